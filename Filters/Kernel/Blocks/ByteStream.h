// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BitingByteStream_h
#define BitingByteStream_h

#include <cstddef>     // for sizes
#include <cstdint>     // for sizes
#include <cstring>     // for copies of bytes
#include <type_traits> // for what may be copied
#include <vector>      // for bytes

namespace biting
{

/// Values as bytes of this machine, for another process.
class ByteWriter
{
public:
  template <typename Value>
  void Put(const Value& value)
  {
    static_assert(std::is_trivially_copyable_v<Value>, "bytes are the value");
    this->PutBytes(&value, sizeof(value));
  }

  template <typename Value>
  void Put(const std::vector<Value>& values)
  {
    static_assert(std::is_trivially_copyable_v<Value>, "bytes are the value");
    this->Put(static_cast<std::uint64_t>(values.size()));
    this->PutBytes(values.data(), values.size() * sizeof(Value));
  }

  /// Bytes as Take reads a list of them.
  template <typename Iterator>
  void PutAll(Iterator first, Iterator last)
  {
    this->Put(static_cast<std::uint64_t>(last - first));
    this->Bytes.insert(this->Bytes.end(), first, last);
  }

  std::vector<char> Bytes;

private:
  void PutBytes(const void* from, std::size_t size)
  {
    const char* first = static_cast<const char*>(from);
    this->Bytes.insert(this->Bytes.end(), first, first + size);
  }
};

/// Reads the values in the order in which they were written. From the first missing byte on the
/// reader is not sound, and its values have no meaning.
class ByteReader
{
public:
  explicit ByteReader(const std::vector<char>& bytes, std::size_t first = 0)
    : Bytes(bytes)
    , Next(first)
  {
  }

  template <typename Value>
  void Take(Value& value)
  {
    static_assert(std::is_trivially_copyable_v<Value>, "bytes are the value");
    this->TakeBytes(&value, sizeof(value));
  }

  template <typename Value>
  void Take(std::vector<Value>& values)
  {
    static_assert(std::is_trivially_copyable_v<Value>, "bytes are the value");
    std::uint64_t size = 0;
    this->Take(size);
    this->IsSound = this->IsSound && size <= (this->Bytes.size() - this->Next) / sizeof(Value);
    if (this->IsSound)
    {
      values.resize(static_cast<std::size_t>(size));
      this->TakeBytes(values.data(), values.size() * sizeof(Value));
    }
  }

  bool IsAtEnd() const { return this->IsSound && this->Next == this->Bytes.size(); }

private:
  void TakeBytes(void* to, std::size_t size)
  {
    this->IsSound = this->IsSound && size <= this->Bytes.size() - this->Next;
    if (this->IsSound && size > 0)
    {
      std::memcpy(to, this->Bytes.data() + this->Next, size);
      this->Next += size;
    }
  }

  const std::vector<char>& Bytes;
  std::size_t Next;
  bool IsSound = true;
};

} // namespace biting

#endif
