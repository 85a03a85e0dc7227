// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_INTERNAL_COMPATIBILITY_H
#define CGAL_QUAD_MESHING_INTERNAL_COMPATIBILITY_H

// All that differs between the versions of CGAL. No other header asks for the version.

#include <CGAL/version.h>

#if CGAL_VERSION_NR >= 1060000000
#include <CGAL/AABB_segment_primitive_3.h>
#include <CGAL/AABB_traits_3.h>
#include <CGAL/AABB_triangle_primitive_3.h>
#else
#include <CGAL/AABB_segment_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_triangle_primitive.h>
#endif

namespace CGAL {
namespace Quad_meshing {
namespace internal {

#if CGAL_VERSION_NR >= 1060000000
template <typename Kernel, typename Primitive>
using Aabb_traits = AABB_traits_3<Kernel, Primitive>;
template <typename Kernel, typename Iterator>
using Aabb_segment_primitive = AABB_segment_primitive_3<Kernel, Iterator>;
template <typename Kernel, typename Iterator>
using Aabb_triangle_primitive = AABB_triangle_primitive_3<Kernel, Iterator>;
#else
template <typename Kernel, typename Primitive>
using Aabb_traits = AABB_traits<Kernel, Primitive>;
template <typename Kernel, typename Iterator>
using Aabb_segment_primitive = AABB_segment_primitive<Kernel, Iterator>;
template <typename Kernel, typename Iterator>
using Aabb_triangle_primitive = AABB_triangle_primitive<Kernel, Iterator>;
#endif

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_INTERNAL_COMPATIBILITY_H
