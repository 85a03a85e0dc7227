// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors
// The kernels of the room Linear_algebra.

#include <CGAL/Quad_meshing/Linear_algebra/internal/Sparse_cholesky_impl.h>

namespace CGAL {
namespace Quad_meshing {

template class Sparse_cholesky<double>;
template class Sparse_cholesky<std::complex<double>>;

} // namespace Quad_meshing
} // namespace CGAL
