// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

#ifndef CGAL_QUAD_MESHING_GEODESICS_INTERNAL_WINDOW_LISTS_H
#define CGAL_QUAD_MESHING_GEODESICS_INTERNAL_WINDOW_LISTS_H

#include <CGAL/Quad_meshing/Geodesics/internal/Window.h>

#include <boost/config.hpp>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {
namespace Quad_meshing {
namespace internal {

// The windows of one edge, sorted along it. `Window_lists` owns the memory.
template <typename FT>
struct Window_list
{
  typedef Window<FT> W;

  W* first = nullptr;
  int size = 0;
  int capacity = 0;

  W* begin() const { return first; }
  W* end() const { return first + size; }
  W& operator[](int i) const { return first[i]; }
};

// The window lists of all edges in a memory of their own: lists are short and many, grow while the front is at
// their edge, and stay as they are behind it. Blocks that a list leaves behind are used again by others.
template <typename FT>
class Window_lists
{
public:
  typedef Window<FT> W;
  typedef Window_list<FT> List;

  explicit Window_lists(std::size_t n) : m_lists(n) {}

  Window_lists(const Window_lists&) = delete;
  Window_lists& operator=(const Window_lists&) = delete;

  List& operator[](int e) { return m_lists[e]; }
  const List& operator[](int e) const { return m_lists[e]; }

  // The number of windows in all lists.
  std::size_t size() const { return m_size; }

  // Makes room for one window at position i.
  BOOST_FORCEINLINE W& insert(List& list, int i)
  {
    if(list.size == list.capacity)
      grow(list, list.size + 1);
    W* const at = list.first + i;
    for(W* p = list.end(); p != at; --p)
      *p = p[-1];
    ++list.size;
    ++m_size;
    return *at;
  }

  // Replaces `removed` windows from position i on by `added` ones that are still to be written. Returns the first.
  W* splice(List& list, int i, int removed, int added)
  {
    const int size = list.size - removed + added;
    if(size > list.capacity)
      grow(list, size);
    W* const from = list.first + i + removed;
    if(added > removed)
      std::move_backward(from, list.end(), list.first + size);
    else if(added < removed)
      std::move(from, list.end(), list.first + i + added);
    list.size = size;
    m_size = m_size + added - removed;
    return list.first + i;
  }

  // Gives back what a list does not use.
  void shrink(List& list)
  {
    const int n = rounded(list.size);
    if(n < list.capacity)
      move(list, n);
  }

  void clear(List& list)
  {
    m_size -= list.size;
    free_block(list);
    list = List();
  }

private:
  enum
  {
    first_capacity = 8,
    smallest_chunk = 256,
    largest_chunk = 2048
  };

  // Blocks have 1 to 16 windows, or 9 to 16 times a power of two.
  static int unit(int n)
  {
    int u = 1;
    while(n > 16 * u)
      u *= 2;
    return u;
  }
  static int rounded(int n)
  {
    const int u = unit(n);
    return (n + u - 1) / u * u;
  }
  static std::size_t block_class(int capacity)
  {
    std::size_t c = 0;
    const int u = unit(capacity);
    for(int k = u; k > 1; k /= 2)
      c += 8;
    return c + capacity / u;
  }

  BOOST_NOINLINE void grow(List& list, int size)
  {
    move(list, rounded((std::max)(2 * list.capacity, (std::max)(size, int(first_capacity)))));
  }

  void move(List& list, int capacity)
  {
    W* const block = capacity == 0 ? nullptr : new_block(capacity);
    std::move(list.begin(), list.end(), block);
    free_block(list);
    list.first = block;
    list.capacity = capacity;
  }

  W* new_block(int capacity)
  {
    const std::size_t c = block_class(capacity), n = static_cast<std::size_t>(capacity);
    if(c < m_free.size() && !m_free[c].empty())
    {
      W* const block = m_free[c].back();
      m_free[c].pop_back();
      return block;
    }
    if(m_left < n)
    {
      m_left =
        (std::max)(n, (std::min)((std::max)(m_total / 8, std::size_t(smallest_chunk)), std::size_t(largest_chunk)));
      m_total += m_left;
      m_chunks.emplace_back(new W[m_left]);
      m_next = m_chunks.back().get();
    }
    W* const block = m_next;
    m_next += n;
    m_left -= n;
    return block;
  }

  void free_block(const List& list)
  {
    if(list.capacity == 0)
      return;
    const std::size_t c = block_class(list.capacity);
    if(m_free.size() <= c)
      m_free.resize(c + 1);
    m_free[c].push_back(list.first);
  }

  std::vector<List> m_lists;
  std::size_t m_size = 0;
  std::vector<std::vector<W*>> m_free; // per class
  std::vector<std::unique_ptr<W[]>> m_chunks;
  W* m_next = nullptr; // what is left of the last chunk
  std::size_t m_left = 0, m_total = 0;
};

} // namespace internal
} // namespace Quad_meshing
} // namespace CGAL

#endif // CGAL_QUAD_MESHING_GEODESICS_INTERNAL_WINDOW_LISTS_H
