#include "generate/image/geoJsonParser.hpp"

#include "core/base/setupError.hpp"

#include <nlohmann/json.hpp>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <regex>
#include <set>
#include <vector>

namespace chesil
{

namespace
{

using Json = nlohmann::json;

/// Looks at each part of the file as it is read.
class Watch
{
public:
    explicit Watch(const TakeFeature& take) : take_(take) {}

    /// Whether the part shall be kept. `depth` counts the lists and objects around it.
    bool operator()(int depth, Json::parse_event_t event, Json& part)
    {
        if (depth > deepestJson)
        {
            throw ValueError("lists or objects more than " + std::to_string(deepestJson) +
                                 " within each other",
                             expectedPolygons);
        }
        if (event == Json::parse_event_t::object_start)
        {
            if (inFeatures_ && depth == 1)
            {
                throw ValueError("features that are no list", "a list of features");
            }
            members_.resize(static_cast<std::size_t>(depth) + 1);
            members_.back().clear();
        }
        if (event == Json::parse_event_t::key)
        {
            noteMember(depth, part.get_ref<const std::string&>());
        }
        return isFeature(depth, event) ? takeFeature(event, part) : true;
    }

    /// Of the part being read, for messages.
    std::string place() const { return inFeatures_ ? "feature " + std::to_string(count_) : "geometry"; }

private:
    /// `depth` is that of the members: one more than their object's.
    void noteMember(int depth, const std::string& name)
    {
        if (!members_[static_cast<std::size_t>(depth) - 1].insert(name).second)
        {
            throw ValueError("the member '" + name + "' twice", "one of each name");
        }
        if (depth == 1)
        {
            inFeatures_ = name == "features";
        }
    }

    bool isFeature(int depth, Json::parse_event_t event) const
    {
        return inFeatures_ && depth == 2 && event != Json::parse_event_t::key;
    }

    bool takeFeature(Json::parse_event_t event, const Json& part)
    {
        const bool starts =
            event == Json::parse_event_t::object_start || event == Json::parse_event_t::array_start;
        if (starts || event == Json::parse_event_t::value)
        {
            ++count_;
        }
        if (starts)
        {
            return true;
        }
        take_(part, place());
        return false;
    }

    const TakeFeature& take_;
    /// Of the open objects, by depth.
    std::vector<std::set<std::string>> members_;
    bool inFeatures_ = false;
    std::size_t count_ = 0;
};

std::ifstream opened(const std::string& path)
{
    errno = 0;
    std::ifstream stream(path);
    if (!stream.good() || stream.peek() == std::ifstream::traits_type::eof())
    {
        throw SetupError(path, "GeoJSON", errno != 0 ? std::strerror(errno) : "an empty file",
                         "a GeoJSON file that can be read");
    }
    return stream;
}

/// Without the "[json.exception.out_of_range.406] " before it.
std::string withoutIdentifier(const std::string& message)
{
    const std::size_t end = message.find("] ");
    return end == std::string::npos ? message : message.substr(end + 2);
}

SetupError unreadable(const std::string& path, const std::string& message)
{
    static const std::regex form(R"(.*parse error at (line \d+), column \d+: (.*))");
    std::smatch parts;
    const bool known = std::regex_match(message, parts, form);
    return SetupError(path, known ? parts[1].str() : "GeoJSON", known ? parts[2].str() : message,
                      "whole GeoJSON with " + std::string(expectedPolygons));
}

} // namespace

void parseGeoJson(const std::string& path, const TakeFeature& take)
{
    std::ifstream stream = opened(path);
    Watch watch(take);
    try
    {
        const Json rest = Json::parse(stream, std::ref(watch));
        const bool isCollection = rest.is_object() && rest.value("type", Json()) == "FeatureCollection";
        if (!isCollection)
        {
            take(rest, watch.place());
        }
    }
    catch (const Json::parse_error& error)
    {
        throw unreadable(path, error.what());
    }
    catch (const Json::out_of_range& error)
    {
        throw SetupError(path, watch.place(), withoutIdentifier(error.what()),
                         "coordinates and other numbers that a double can hold");
    }
    catch (const ValueError& error)
    {
        throw error.at(path, watch.place());
    }
}

} // namespace chesil
