#include "mrpt_ext/front_ends/camera_file.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "mrpt_ext/files/text_file.h"
#include "mrpt_ext/geometry/input_error.h"

namespace mrpt_ext
{
namespace
{
using Json = nlohmann::json;

const Json* objectIn(const Json* parent, const char* name)
{
  const bool present = parent && parent->is_object() && parent->contains(name) && (*parent)[name].is_object();
  return present ? &(*parent)[name] : nullptr;
}

double numberOf(const Json& value, const std::string& name)
{
  if (!value.is_number()) throw dataError("camera.json: " + name + " is no number");
  const double number = value.get<double>();
  if (!(std::abs(number) <= kLargestNumber)) throw dataError("camera.json: " + name + " is beyond any meaning");
  return number;
}

std::optional<double> numberIn(const Json* object, const std::string& name)
{
  if (!object || !object->contains(name)) return std::nullopt;
  return numberOf((*object)[name], name);
}
}  // namespace

CameraFile::CameraFile(const std::map<std::string, double>& numbers) : camera_(std::make_shared<const Json>(numbers)) {}

CameraFile CameraFile::read(const std::filesystem::path& file)
{
  CameraFile result;
  if (!std::filesystem::exists(file)) return result;
  const Json content = Json::parse(readTextFile(file), nullptr, false);
  const Json* const camera = objectIn(&content, "camera");
  const Json* const object = camera ? camera : objectIn(&content, "stereo");
  if (!object) throw dataError(file.string() + ": damaged, expected JSON with an object \"camera\" or \"stereo\"");
  Json stated = *object;
  if (const Json* const field = objectIn(&content, "field")) stated["field"] = *field;
  result.camera_ = std::make_shared<const Json>(std::move(stated));
  return result;
}

std::optional<double> CameraFile::number(const std::string& name) const { return numberIn(camera_.get(), name); }

std::optional<double> CameraFile::fieldNumber(const std::string& name) const
{
  return numberIn(objectIn(camera_.get(), "field"), name);
}

std::string CameraFile::textWith(const std::map<std::string, double>& numbers) const
{
  Json camera = camera_ ? *camera_ : Json::object();
  Json content = Json::object();
  if (const Json* const field = objectIn(&camera, "field")) content["field"] = *field;
  camera.erase("field");
  for (const auto& [name, number] : numbers) camera[name] = number;
  content["camera"] = std::move(camera);
  return content.dump(1) + "\n";
}

std::optional<std::vector<double>> CameraFile::centres() const
{
  if (!camera_ || !camera_->contains("centers")) return std::nullopt;
  std::vector<double> all;
  for (const Json& centre : (*camera_)["centers"])
  {
    if (!centre.is_array() || centre.size() != 2)
      throw dataError("camera.json: centers: expected [cx, cy] of each camera");
    for (const Json& coordinate : centre) all.push_back(numberOf(coordinate, "centers"));
  }
  return all;
}

std::optional<double> CameraNumbers::optional(const char* key, const char* name) const
{
  if (const auto number = settings_.optionalNumber(section_, key)) return number;
  return file_.number(name);
}

double CameraNumbers::required(const char* key, const char* name) const
{
  if (const auto number = optional(key, name)) return *number;
  throw missing(key, name);
}

double CameraNumbers::size(const char* key, const char* name) const { return positive(key, name, file_.number(name)); }

double CameraNumbers::fieldSize(const char* key, const char* name) const
{
  return positive(key, name, file_.fieldNumber(name));
}

double CameraNumbers::positive(const char* key, const char* name, const std::optional<double>& stated) const
{
  if (const auto number = settings_.optionalNumber(section_, key)) return *number;
  if (!stated) throw missing(key, name);
  if (!(*stated > 0)) throw dataError(std::string("camera.json: ") + name + " is not above zero");
  return *stated;
}

InputError CameraNumbers::missing(const char* key, const char* name) const
{
  return configurationError(settings_.file().string() + ": [" + section_ + "] " + key +
                            " is missing, expected it here or as " + name + " in camera.json");
}
}  // namespace mrpt_ext
