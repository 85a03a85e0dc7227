// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_WRITE_PNG_PICTURE_H
#define CGAL_QUAD_MESHING_IO_WRITE_PNG_PICTURE_H

#include <CGAL/Quad_meshing/IO/Scene.h>
#include <CGAL/Quad_meshing/IO/Scene_writing_result.h>
#include <CGAL/Quad_meshing/internal/compiled_kernels.h>

#include <ostream>

namespace CGAL {
namespace Quad_meshing {

/*!
\ingroup PkgQuadMeshingIORef

\brief What a picture of `write_png_picture()` shows of a scene.
*/
struct Png_picture_options
{
  int width = 640;                     ///< in pixels
  int height = 480;                    ///< in pixels
  Scene_side side = Scene_side::RIGHT; ///< the layers of this side and those of both; `BOTH`: all layers
};

/*!
\ingroup PkgQuadMeshingIORef

\brief writes a picture of the visible layers of a scene in the format PNG, from the side from which a page of
`write_html_page()` shows them at first. They fill the picture.

It is drawn in software: no display, no browser and no library is needed. An integer grid is drawn as a chessboard.

\param os the stream, which should be a file opened in binary mode
\param scene what is shown
\param options size and side; a width or height that is not positive counts as 1

\return whether the picture was written, and why not; `NO_VIEWER` does not occur
*/
CGAL_QUAD_MESHING_INLINE Scene_writing_result
write_png_picture(std::ostream& os, const Scene& scene, const Png_picture_options& options = Png_picture_options());

} // namespace Quad_meshing
} // namespace CGAL

#ifndef CGAL_QUAD_MESHING_COMPILED_KERNELS
#include <CGAL/Quad_meshing/IO/internal/write_png_picture_impl.h>
#endif

#endif // CGAL_QUAD_MESHING_IO_WRITE_PNG_PICTURE_H
