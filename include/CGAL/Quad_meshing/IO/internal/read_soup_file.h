// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_INTERNAL_READ_SOUP_FILE_H
#define CGAL_QUAD_MESHING_IO_INTERNAL_READ_SOUP_FILE_H

#include <CGAL/Quad_meshing/IO/Mesh_attributes.h>
#include <CGAL/Quad_meshing/IO/Mesh_reading_result.h>
#include <CGAL/Quad_meshing/IO/internal/Polygon_soup.h>
#include <CGAL/Quad_meshing/internal/compiled_kernels.h>

#include <string>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The extension of a file name in lower case letters, without the dot.
CGAL_QUAD_MESHING_INLINE std::string file_extension(const std::string& filename);

// Reads the polygons of a file. After success there is at least one, all indices are valid and all coordinates finite.
// Else the reason is in `result`.
// `attributes`: receives what the file says besides; null: that is passed over.
CGAL_QUAD_MESHING_INLINE bool read_soup_file(const std::string& filename, Polygon_soup& soup,
                                             Mesh_reading_result& result, Mesh_attributes* attributes = nullptr);

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#ifndef CGAL_QUAD_MESHING_COMPILED_KERNELS
#include <CGAL/Quad_meshing/IO/internal/read_soup_file_impl.h>
#endif

#endif // CGAL_QUAD_MESHING_IO_INTERNAL_READ_SOUP_FILE_H
