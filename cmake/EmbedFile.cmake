# SPDX-License-Identifier: MIT
# cmake -D INPUT=file -D OUTPUT=file.inc -P EmbedFile.cmake: the bytes of a file as a C list.
file(READ ${INPUT} bytes HEX)
string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${bytes}")
file(WRITE ${OUTPUT} "${bytes}")
