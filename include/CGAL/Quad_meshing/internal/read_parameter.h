// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_INTERNAL_READ_PARAMETER_H
#define CGAL_QUAD_MESHING_INTERNAL_READ_PARAMETER_H

#include <CGAL/Named_function_parameters.h>

#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Gives `value` what the named parameter of the tag says; it keeps its default if there is none.
template <typename NamedParameters, typename Tag, typename T>
void read_parameter(const NamedParameters& np, Tag tag, T& value)
{
  value = parameters::choose_parameter(parameters::get_parameter(np, tag), value);
}

// The same for a range of values, which becomes a vector.
template <typename NamedParameters, typename Tag, typename T>
void read_range(const NamedParameters& np, Tag tag, std::vector<T>& values)
{
  if constexpr(!parameters::is_default_parameter<NamedParameters, Tag>::value)
  {
    const auto& range = parameters::get_parameter(np, tag);
    values.assign(range.begin(), range.end());
  }
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_INTERNAL_READ_PARAMETER_H
