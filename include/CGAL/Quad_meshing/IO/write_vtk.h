// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_WRITE_VTK_H
#define CGAL_QUAD_MESHING_IO_WRITE_VTK_H

#include <CGAL/Quad_meshing/IO/Scene.h>
#include <CGAL/Quad_meshing/IO/Scene_writing_result.h>
#include <CGAL/Quad_meshing/internal/compiled_kernels.h>

#include <ostream>

namespace CGAL {
namespace Quad_meshing {

/*!
\ingroup PkgQuadMeshingIORef

\brief writes a layer of a scene in the legacy format of VTK, which ParaView and many other programs read: its faces,
lines or points, and all its numbers as data of the cells.

\param os the stream; its precision says how many digits numbers have
\param layer the layer; blanks in the names of its numbers become underscores

\return whether the layer was written, and why not; `NO_VIEWER` does not occur
*/
CGAL_QUAD_MESHING_INLINE Scene_writing_result write_vtk(std::ostream& os, const Scene_layer& layer);

} // namespace Quad_meshing
} // namespace CGAL

#ifndef CGAL_QUAD_MESHING_COMPILED_KERNELS
#include <CGAL/Quad_meshing/IO/internal/write_vtk_impl.h>
#endif

#endif // CGAL_QUAD_MESHING_IO_WRITE_VTK_H
