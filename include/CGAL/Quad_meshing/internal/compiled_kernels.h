// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_INTERNAL_COMPILED_KERNELS_H
#define CGAL_QUAD_MESHING_INTERNAL_COMPILED_KERNELS_H

// The numerical kernels work on flat arrays and are no templates. A light header declares them; a file `*_impl.h`
// beside it defines them and includes what is expensive to compile.
//
// With CGAL_QUAD_MESHING_COMPILED_KERNELS, which the target CGAL::Quad_meshing defines, the definitions come from the
// library of that target. Without, the package is header-only: every light header includes its definitions at its end.

#ifdef CGAL_QUAD_MESHING_COMPILED_KERNELS
#define CGAL_QUAD_MESHING_INLINE
#else
#define CGAL_QUAD_MESHING_INLINE inline
#endif

#endif // CGAL_QUAD_MESHING_INTERNAL_COMPILED_KERNELS_H
