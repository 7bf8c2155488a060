// SPDX-License-Identifier: MIT
//
// The command as its users meet it: in a shell, in a directory of its own.
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdio>
#include <string>

#include "lab/capture/output_file.h"
#include "lab/capture/temporary_directory.h"

namespace reprise::lab {

struct Ran {
  int code = -1;
  std::string out;
  std::string error;
};

class CommandLine : public testing::Test {
 protected:
  Ran shell(const std::string& command) const {
    const std::string error_path = path("stderr");
    std::FILE* pipe = popen(
        ("cd " + directory.path().string() + " && " + command + " 2>" + error_path).c_str(), "r");
    Ran ran;
    char buffer[4096];
    for (size_t n; (n = std::fread(buffer, 1, sizeof(buffer), pipe)) > 0;)
      ran.out.append(buffer, n);
    const int status = pclose(pipe);
    ran.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    ran.error = readWholeFile(error_path);
    return ran;
  }
  Ran reprise(const std::string& arguments) const {
    return shell("REPRISE_CACHE=" + path("cache") + " " REPRISE_COMMAND " " + arguments);
  }
  std::string path(const char* name) const { return (directory.path() / name).string(); }
  bool exists(const char* name) const { return std::filesystem::exists(directory.path() / name); }

  // What the page leaves between "PROBE " and " END" once `script` has worked it in a browser.
  // Checks that it fetches nothing. Empty where there is no browser.
  std::string probe(const std::string& page_path, const std::string& script_path) const {
    if (std::system("chromium --version >/dev/null 2>&1") != 0) return "";
    const std::string page = readWholeFile(page_path);
    for (const char* mark : {" src=\"http", "href=\"http", "@import", "url(http"}) {
      EXPECT_EQ(page.find(mark), std::string::npos) << mark;
    }
    writeOutputFile(path("probe.html"),
                    page + "<script>" + readWholeFile(script_path) + "</script>");
    const Ran ran = shell(
        "timeout 120 chromium --headless=new --no-sandbox --disable-gpu --disable-dev-shm-usage "
        "--disable-background-networking --no-first-run --user-data-dir=profile "
        "--window-size=1200,1000 --virtual-time-budget=20000 --dump-dom file://" +
        path("probe.html"));
    const size_t begin = ran.out.rfind("PROBE ");
    EXPECT_NE(begin, std::string::npos) << ran.error.substr(0, 2000);
    if (begin == std::string::npos) return "error=";
    return ran.out.substr(begin, ran.out.find(" END", begin) - begin);
  }

  TemporaryDirectory directory;
};

}  // namespace reprise::lab
