// Messages made by a program's own allocator.
#pragma once
#include <memory>
#include <stdexcept>

namespace rclcpp::allocator
{
template<class T, class Alloc>
using AllocRebind = typename std::allocator_traits<Alloc>::template rebind_traits<T>;

template<class Alloc>
class AllocatorDeleter
{
  template<class T>
  using Rebound = typename std::allocator_traits<Alloc>::template rebind_alloc<T>;

public:
  AllocatorDeleter() = default;
  explicit AllocatorDeleter(Alloc * allocator)
  : allocator_(allocator) {}
  template<class T>
  void operator()(T * message)
  {
    Rebound<T> own = allocator_ ? Rebound<T>(*allocator_) : Rebound<T>();
    std::allocator_traits<Rebound<T>>::destroy(own, message);
    std::allocator_traits<Rebound<T>>::deallocate(own, message, 1);
  }
  Alloc * get_allocator() const {return allocator_;}
  void set_allocator(Alloc * allocator) {allocator_ = allocator;}

private:
  Alloc * allocator_ = nullptr;
};
template<class Alloc, class T>
using Deleter = std::conditional_t<
  std::is_same_v<typename std::allocator_traits<Alloc>::template rebind_alloc<T>, std::allocator<T>>,
  std::default_delete<T>, AllocatorDeleter<Alloc>>;

template<class D, class Alloc>
void set_allocator_for_deleter(D * deleter, Alloc * allocator)
{
  if (!allocator || !deleter) {
    throw std::invalid_argument("Argument was NULL to set_allocator_for_deleter");
  }
  deleter->set_allocator(allocator);
}
template<class Alloc, class T>
void set_allocator_for_deleter(std::default_delete<T> *, Alloc *) {}
}  // namespace rclcpp::allocator
