// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_INTERNAL_READ_TEXT_FILE_H
#define CGAL_QUAD_MESHING_IO_INTERNAL_READ_TEXT_FILE_H

#include <fstream>
#include <iterator>
#include <string>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The content of a file. Returns whether it could be read.
inline bool read_text_file(const std::string& filename, std::string& text)
{
  std::ifstream in(filename, std::ios::in | std::ios::binary);
  if(!in)
    return false;
  text.assign(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
  return !in.bad();
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_IO_INTERNAL_READ_TEXT_FILE_H
