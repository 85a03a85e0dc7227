// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_INTERNAL_RUN_ASIDE_H
#define CGAL_QUAD_MESHING_INTERNAL_RUN_ASIDE_H

#include <CGAL/Quad_meshing/internal/Stage_progress.h>

#include <chrono>
#include <future>
#include <memory>
#include <thread>
#include <utility>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// Runs work(*data) that knows no visitor, such as the factorization of a matrix, and keeps the visitor informed
// meanwhile: from `size` on, which is measured in rows, the work has a thread of its own. Returns false if the visitor
// stops it. Then the thread is left to end by itself, as no library for sparse matrices can be interrupted: the work
// may touch nothing but `data`, and the caller does not touch that any more.
template <typename Data, typename Work>
bool run_aside(int size, Stage_progress& progress, const std::shared_ptr<Data>& data, const Work& work)
{
  // Factorizations of so few rows take some hundredths of a second.
  const int few = 20000;
  const std::chrono::milliseconds between_reports(50);

  if(size < few)
  {
    work(*data);
    return progress.go_further();
  }
  std::packaged_task<void()> task([data, work] { work(*data); });
  std::future<void> done = task.get_future();
  std::thread thread(std::move(task));
  while(done.wait_for(between_reports) != std::future_status::ready)
    if(!progress.go_further())
    {
      thread.detach();
      return false;
    }
  thread.join();
  done.get(); // passes an exception on
  return progress.go_further();
}

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_INTERNAL_RUN_ASIDE_H
