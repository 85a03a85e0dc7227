// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_READ_MESH_ATTRIBUTES_H
#define CGAL_QUAD_MESHING_IO_READ_MESH_ATTRIBUTES_H

#include <CGAL/Quad_meshing/IO/Mesh_attributes.h>
#include <CGAL/Quad_meshing/IO/Mesh_reading_result.h>
#include <CGAL/Quad_meshing/internal/compiled_kernels.h>

#include <string>

namespace CGAL {
namespace Quad_meshing {

/*!
\ingroup PkgQuadMeshingIORef

\brief reads what a file says about its faces, corners and vertices besides the shape: groups, materials, texture
coordinates, normals, colors.

Formats are those of `read_triangle_mesh()`; OBJ has all of these, PLY colors, OFF and STL none. A file that cannot be
read leaves `attributes` as they were.

\param filename the name of the file
\param attributes the attributes, in place of what was there

\return whether and how it ended

\sa `find_attribute_borders()`
*/
CGAL_QUAD_MESHING_INLINE Mesh_reading_result read_mesh_attributes(const std::string& filename,
                                                                  Mesh_attributes& attributes);

} // namespace Quad_meshing
} // namespace CGAL

#ifndef CGAL_QUAD_MESHING_COMPILED_KERNELS
#include <CGAL/Quad_meshing/IO/internal/read_mesh_attributes_impl.h>
#endif

#endif // CGAL_QUAD_MESHING_IO_READ_MESH_ATTRIBUTES_H
