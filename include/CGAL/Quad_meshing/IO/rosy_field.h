// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_ROSY_FIELD_H
#define CGAL_QUAD_MESHING_IO_ROSY_FIELD_H

#include <CGAL/Quad_meshing/IO/Mesh_reading_result.h>
#include <CGAL/Quad_meshing/internal/compiled_kernels.h>

#include <CGAL/number_utils.h>

#include <array>
#include <iterator>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_meshing {

/*!
\ingroup PkgQuadMeshingIORef

\brief reads a cross field in the format `.rosy`: the number of faces, the number of directions per face, which must be
4, and one direction of each face as three numbers. The other directions are those turned by right angles.

\param filename the name of the file, whatever its extension is
\param directions receives the directions, face by face, as they are in the file: of any length, and the zero vector
where there is none

\return whether and how it ended; after a failure `directions` is as it was
*/
CGAL_QUAD_MESHING_INLINE Mesh_reading_result read_rosy_field(const std::string& filename,
                                                             std::vector<std::array<double, 3>>& directions);

/*!
\ingroup PkgQuadMeshingIORef

\brief writes a cross field in the format `.rosy`, see `read_rosy_field()`.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam FaceDirection a function object that takes a face and returns a 3D vector

\param os the stream
\param tm the mesh that the field lies on
\param direction one of the four directions of a face

\return whether the stream is good
*/
template <typename TriangleMesh, typename FaceDirection>
bool write_rosy_field(std::ostream& os, const TriangleMesh& tm, FaceDirection direction)
{
  os.precision(std::numeric_limits<double>::max_digits10);
  const auto range = faces(tm);
  os << std::distance(range.begin(), range.end()) << "\n4\n";
  for(auto f : faces(tm))
  {
    const auto d = direction(f);
    os << to_double(d.x()) << " " << to_double(d.y()) << " " << to_double(d.z()) << "\n";
  }
  return os.good();
}

} // namespace Quad_meshing
} // namespace CGAL

#ifndef CGAL_QUAD_MESHING_COMPILED_KERNELS
#include <CGAL/Quad_meshing/IO/internal/read_rosy_field_impl.h>
#endif

#endif // CGAL_QUAD_MESHING_IO_ROSY_FIELD_H
