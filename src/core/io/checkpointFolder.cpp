#include "core/io/checkpointFolder.hpp"

#include "core/base/setupError.hpp"
#include "core/io/durableFile.hpp"

#include <algorithm>
#include <charconv>
#include <filesystem>

namespace chesil
{

namespace
{

namespace fs = std::filesystem;

const std::string prefix = "checkpoint_";

/// Zeros in front, so that names sort like steps.
std::string nameOf(std::uint64_t step)
{
    constexpr std::size_t mostDigits = 20;
    const std::string digits = std::to_string(step);
    return prefix + std::string(mostDigits - digits.size(), '0') + digits;
}

/// The step of a name that nameOf made; nothing for others.
std::optional<std::uint64_t> stepOf(const std::string& name)
{
    const std::size_t begin = std::min(prefix.size(), name.size());
    std::uint64_t step = 0;
    std::from_chars(name.data() + begin, name.data() + name.size(), step);
    return nameOf(step) == name ? std::optional<std::uint64_t>(step) : std::nullopt;
}

struct Listing
{
    /// Names of checkpoints, newest first, and of half written ones.
    std::vector<std::string> checkpoints;
    std::vector<std::string> parts;
};

Listing list(const std::string& folder)
{
    const std::string suffix = partSuffix;
    Listing listing;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
    {
        const std::string name = entry->path().filename();
        const std::size_t stem = name.size() - std::min(name.size(), suffix.size());
        if (stepOf(name))
        {
            listing.checkpoints.push_back(name);
        }
        else if (name.compare(stem, std::string::npos, suffix) == 0 && stepOf(name.substr(0, stem)))
        {
            listing.parts.push_back(name);
        }
    }
    if (error)
    {
        throw SetupError(folder, "(folder of checkpoints)", error.message(), "a folder that can be read");
    }
    std::sort(listing.checkpoints.rbegin(), listing.checkpoints.rend());
    return listing;
}

/// Nothing if the file is whole.
std::optional<std::string> whyBroken(const std::string& path)
{
    try
    {
        requireWholeCheckpoint(path);
        return std::nullopt;
    }
    catch (const SetupError& error)
    {
        return error.what();
    }
}

void removeFile(const std::string& path)
{
    std::error_code error;
    fs::remove(path, error);
    if (error)
    {
        throw SetupError(path, "(whole file)", "an error while removing it: " + error.message(),
                         "a folder that can be written to");
    }
}

} // namespace

void CheckpointFolder::write(CheckpointWriter writer, std::uint64_t step, double time) const
{
    const std::string name = nameOf(step);
    const auto pathOf = [&](const std::string& file) { return folder_ + "/" + file; };
    const Listing before = list(folder_);
    for (const std::string& other : before.checkpoints)
    {
        if (other > name && !whyBroken(pathOf(other)))
        {
            throw SetupError(pathOf(other), "step", "a later one than " + std::to_string(step),
                             "a run that went on from its newest checkpoint, or a folder without old ones");
        }
    }
    for (const std::string& part : before.parts)
    {
        removeFile(pathOf(part));
    }

    writer.add("step", std::vector<std::uint64_t>{step});
    writer.add("time", std::vector<double>{time});
    writer.write(pathOf(name));

    bool anotherIsWhole = false;
    for (const std::string& other : before.checkpoints)
    {
        if (other >= name)
        {
            continue;
        }
        if (anotherIsWhole)
        {
            removeFile(pathOf(other));
        }
        else
        {
            anotherIsWhole = !whyBroken(pathOf(other));
        }
    }
}

NewestCheckpoint CheckpointFolder::newestValid() const
{
    NewestCheckpoint newest;
    for (const std::string& name : list(folder_).checkpoints)
    {
        const std::string path = folder_ + "/" + name;
        const std::optional<std::string> reason = whyBroken(path);
        if (!reason)
        {
            newest.path = path;
            return newest;
        }
        newest.broken.push_back(*reason);
    }
    return newest;
}

} // namespace chesil
