// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// Named test cases: a test program runs all of them, or those whose names are its arguments.

#ifndef TEST_CASES_H
#define TEST_CASES_H

#include <cstdlib>
#include <functional>
#include <iostream>
#include <set>
#include <string>
#include <vector>

struct Test_case
{
  std::string name;
  std::function<void()> run;
};

// The body of main(). `--list` prints the names; a name that does not exist is an error.
inline int run_cases(int argc, char** argv, const std::vector<Test_case>& cases)
{
  std::set<std::string> wanted(argv + 1, argv + argc);
  const bool only_list = wanted.erase("--list") != 0, all = wanted.empty();
  for(const Test_case& c : cases)
  {
    const bool is_wanted = wanted.erase(c.name) != 0 || all;
    if(only_list)
      std::cout << c.name << std::endl;
    else if(is_wanted)
    {
      std::cout << "case " << c.name << std::endl;
      c.run();
    }
  }
  for(const std::string& name : wanted)
    std::cerr << "There is no case named " << name << "; --list prints those there are." << std::endl;
  return wanted.empty() ? EXIT_SUCCESS : EXIT_FAILURE;
}

#endif // TEST_CASES_H
