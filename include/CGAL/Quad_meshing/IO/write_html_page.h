// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_IO_WRITE_HTML_PAGE_H
#define CGAL_QUAD_MESHING_IO_WRITE_HTML_PAGE_H

#include <CGAL/Quad_meshing/IO/Scene.h>
#include <CGAL/Quad_meshing/IO/Scene_writing_result.h>
#include <CGAL/Quad_meshing/internal/compiled_kernels.h>

#include <ostream>

namespace CGAL {
namespace Quad_meshing {

/*!
\ingroup PkgQuadMeshingIORef

\brief tells whether the package was built with three.js, which `write_html_page()` needs.
*/
CGAL_QUAD_MESHING_INLINE bool has_html_viewer();

/*!
\ingroup PkgQuadMeshingIORef

\brief writes a page that shows a scene in three dimensions, in one file that needs nothing else.

Every browser with WebGL opens the page, without network. It has a switch for each layer, draws all of them in one
picture or in two side by side, turns, moves and zooms, colors elements by their numbers, and tells the numbers of the
element that is clicked; beside it stand message, histograms and tables. The library three.js is part of the page.

Points are stored in single precision with respect to the center of the model. A triangle takes about 28 bytes of the
file, with a grid 60; the viewer takes 0.9 MB.

\param os the stream, which should be a file opened in binary mode
\param scene what is shown

\return whether the page was written, and why not
*/
CGAL_QUAD_MESHING_INLINE Scene_writing_result write_html_page(std::ostream& os, const Scene& scene);

} // namespace Quad_meshing
} // namespace CGAL

#ifndef CGAL_QUAD_MESHING_COMPILED_KERNELS
#include <CGAL/Quad_meshing/IO/internal/write_html_page_impl.h>
#endif

#endif // CGAL_QUAD_MESHING_IO_WRITE_HTML_PAGE_H
