#include "mrpt_ext/rawlog/sha256.h"

#include <openssl/evp.h>

#include <array>
#include <fstream>
#include <vector>

namespace mrpt_ext
{
Sha256::Sha256() : context_(EVP_MD_CTX_new(), &EVP_MD_CTX_free)
{
  EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr);
}

void Sha256::add(std::span<const unsigned char> bytes) { EVP_DigestUpdate(context_.get(), bytes.data(), bytes.size()); }

std::string Sha256::hex()
{
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int length = 0;
  EVP_DigestFinal_ex(context_.get(), digest.data(), &length);
  constexpr const char* kDigits = "0123456789abcdef";
  std::string text;
  for (unsigned int i = 0; i < length; ++i) (text += kDigits[digest[i] >> 4]) += kDigits[digest[i] & 15];
  return text;
}

std::string sha256OfText(std::string_view text)
{
  Sha256 digest;
  digest.add({reinterpret_cast<const unsigned char*>(text.data()), text.size()});
  return digest.hex();
}

std::string sha256OfFile(const std::filesystem::path& path)
{
  std::ifstream file(path, std::ios::binary);
  if (!file) return {};
  Sha256 digest;
  std::vector<unsigned char> buffer(1 << 16);
  while (file)
  {
    file.read(reinterpret_cast<char*>(buffer.data()), static_cast<std::streamsize>(buffer.size()));
    digest.add({buffer.data(), static_cast<std::size_t>(file.gcount())});
  }
  return file.bad() ? std::string() : digest.hex();
}
}  // namespace mrpt_ext
