// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_INTERNAL_PARALLEL_FOR_H
#define CGAL_QUAD_MESHING_INTERNAL_PARALLEL_FOR_H

#include <algorithm>
#include <cstddef>
#include <thread>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Calls work(i) for all i below n, from several threads. Calls for different i must not touch the same data; then the
// outcome does not depend on the number of threads. `work` must not throw.
template <typename Work>
void parallel_for(std::size_t n, unsigned int number_of_threads, const Work& work)
{
  const std::size_t least_per_thread = 500; // starting a thread costs as much as some hundred calls
  const std::size_t threads =
    (std::max)(std::size_t(1), (std::min)(std::size_t(number_of_threads), n / least_per_thread));
  auto part = [&](std::size_t t)
  {
    for(std::size_t i = n * t / threads; i < n * (t + 1) / threads; ++i)
      work(i);
  };
  std::vector<std::thread> others;
  for(std::size_t t = 1; t < threads; ++t)
    others.emplace_back(part, t);
  part(0);
  for(std::thread& t : others)
    t.join();
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_INTERNAL_PARALLEL_FOR_H
