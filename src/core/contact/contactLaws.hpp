#pragma once

#include "core/contact/hertzMindlinLaw.hpp"
#include "core/contact/linearLaw.hpp"

#include <algorithm>
#include <cstddef>
#include <variant>
#include <vector>

namespace chesil
{

/// One law with the parameters of each pair of materials.
template <class Law>
class LawTable
{
public:
    /// One material.
    LawTable() : materials_(1), laws_(1) {}

    explicit LawTable(std::size_t materials) : materials_(materials), laws_(materials * materials) {}

    std::size_t materials() const { return materials_; }

    const Law& of(std::size_t a, std::size_t b) const { return laws_[a * materials_ + b]; }

    void set(std::size_t a, std::size_t b, const Law& law)
    {
        laws_[a * materials_ + b] = law;
        laws_[b * materials_ + a] = law;
    }

    /// That of a table with one material.
    Law& only() { return laws_.front(); }

    template <class Predicate>
    bool any(Predicate predicate) const
    {
        return std::any_of(laws_.begin(), laws_.end(), predicate);
    }

    const std::vector<Law>& all() const { return laws_; }

private:
    std::size_t materials_;
    std::vector<Law> laws_;
};

/// The laws there are; a scene uses one of them. A new law is a file like linearLaw.hpp and its name here.
using ContactLaws = std::variant<LawTable<LinearLaw>, LawTable<HertzMindlinLaw>>;

} // namespace chesil
