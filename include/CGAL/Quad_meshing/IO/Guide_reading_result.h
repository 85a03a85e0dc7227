// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_GUIDE_READING_RESULT_H
#define CGAL_QUAD_MESHING_IO_GUIDE_READING_RESULT_H

#include <string>

namespace CGAL {
namespace Quad_meshing {

/*!
 * \ingroup PkgQuadMeshingIORef
 *
 * \brief is the answer of the functions that read what a user has drawn.
 */
struct Guide_reading_result
{
  /// What is wrong, as a sentence that begins with the line it is about; empty if nothing is.
  std::string message;

  /// returns whether the file was read.
  bool is_valid() const { return message.empty(); }
};

} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_IO_GUIDE_READING_RESULT_H
