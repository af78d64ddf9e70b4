#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "mrpt_ext/settings/settings.h"

namespace mrpt_ext
{
/// What the images' own camera.json states about their camera, or a rawlog under the same names. Getters throw
/// InputError (data) for a value of the wrong type.
class CameraFile
{
 public:
  CameraFile() = default;
  explicit CameraFile(const std::map<std::string, double>& numbers);
  /// Object `camera` or `stereo` of the file, with its object `field` within. A missing file states nothing; throws
  /// InputError (data) when it has neither object.
  static CameraFile read(const std::filesystem::path& file);

  [[nodiscard]] std::optional<double> number(const std::string& name) const;
  /// Of the object `field`.
  [[nodiscard]] std::optional<double> fieldNumber(const std::string& name) const;
  /// The text of a camera.json that states these numbers of the camera instead, and all else as before.
  [[nodiscard]] std::string textWith(const std::map<std::string, double>& numbers) const;
  /// cx, cy [px] of one camera after the other: `centers`.
  [[nodiscard]] std::optional<std::vector<double>> centres() const;

 private:
  std::shared_ptr<const nlohmann::json> camera_;  // null: nothing is stated; shared by copies, never changed
};

/// Numbers of a camera from a section of the .ini, which wins, or from camera.json.
class CameraNumbers
{
 public:
  /// All three must outlive it.
  CameraNumbers(const Settings& settings, const char* section, const CameraFile& file)
      : settings_(settings), section_(section), file_(file)
  {
  }
  /// `key` in the .ini, `name` in camera.json.
  [[nodiscard]] std::optional<double> optional(const char* key, const char* name) const;
  /// The same; throws InputError (configuration) naming both when neither has it.
  [[nodiscard]] double required(const char* key, const char* name) const;
  /// The same, above zero.
  [[nodiscard]] double size(const char* key, const char* name) const;
  [[nodiscard]] double fieldSize(const char* key, const char* name) const;
  [[nodiscard]] InputError missing(const char* key, const char* name) const;

 private:
  [[nodiscard]] double positive(const char* key, const char* name, const std::optional<double>& stated) const;

  const Settings& settings_;
  const char* section_;
  const CameraFile& file_;
};
}  // namespace mrpt_ext
