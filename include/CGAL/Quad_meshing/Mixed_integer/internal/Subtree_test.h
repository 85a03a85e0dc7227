// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_SUBTREE_TEST_H
#define CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_SUBTREE_TEST_H

#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// What a `Lattice_enumeration` asks before it searches a large subtree, that over the first k coordinates with the
// others fixed.
class Subtree_test
{
public:
  struct Distance
  {
    double mean, deviation;
  };

  virtual ~Subtree_test() = default;

  // Whether subtrees over so many coordinates can be tested.
  virtual bool has_level(int k) const = 0;

  // Of the lower bounds of the squared distance that the free coordinates add, over random targets.
  virtual Distance distance(int k) const = 0;

  // What a test takes that is not decided at once, in nodes of the plain enumeration.
  virtual double nodes_per_test(int k) const = 0;

  // Whether it is proven that the free coordinates add at least `squared_radius` where those of `z` from k on are
  // fixed.
  virtual bool exceeds(int k, const std::vector<double>& z, double squared_radius) = 0;

  // What has been done so far, in nodes of the plain enumeration.
  virtual double nodes() const = 0;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_MIXED_INTEGER_INTERNAL_SUBTREE_TEST_H
