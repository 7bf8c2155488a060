# SPDX-License-Identifier: MIT
# reprise_shaders(TARGET INCLUDES dir... SOURCES file...)
# Compiles each GLSL file with glslc and embeds the words in a header: a.comp -> "a.comp.inc", a
# comma-separated list, to be included inside the braces of a constexpr uint32_t array.
find_program(GLSLC glslc REQUIRED)

function(reprise_shaders target)
  cmake_parse_arguments(ARG "" "" "INCLUDES;SOURCES" ${ARGN})
  set(out_dir ${CMAKE_CURRENT_BINARY_DIR}/shaders)
  set(include_flags "")
  foreach(dir IN LISTS ARG_INCLUDES)
    list(APPEND include_flags -I ${dir})
  endforeach()
  set(outputs "")
  foreach(source IN LISTS ARG_SOURCES)
    get_filename_component(source ${source} ABSOLUTE)
    get_filename_component(name ${source} NAME)
    set(output ${out_dir}/${name}.inc)
    add_custom_command(
      OUTPUT ${output}
      COMMAND ${GLSLC} --target-env=vulkan1.2 -O -Werror -mfmt=num ${include_flags}
              -MD -MF ${output}.d -o ${output} ${source}
      DEPENDS ${source}
      DEPFILE ${output}.d
      COMMENT "Compiling shader ${name}"
      VERBATIM)
    list(APPEND outputs ${output})
  endforeach()
  target_sources(${target} PRIVATE ${outputs})
  target_include_directories(${target} PRIVATE ${out_dir})
endfunction()
