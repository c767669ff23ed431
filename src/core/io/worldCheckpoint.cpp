#include "core/io/worldCheckpoint.hpp"

#include "core/base/setupError.hpp"

namespace chesil
{

namespace
{

std::vector<double> flat(const std::vector<Vector2>& vectors)
{
    std::vector<double> numbers;
    numbers.reserve(2 * vectors.size());
    for (const Vector2& vector : vectors)
    {
        numbers.insert(numbers.end(), {vector.x(), vector.y()});
    }
    return numbers;
}

/// Rows of `width` numbers each.
class Rows
{
public:
    Rows(CheckpointReader& reader, const std::string& name, std::size_t width)
    : numbers_(reader.take<double>(name)), width_(width)
    {
        if (numbers_.size() % width != 0)
        {
            throw SetupError(
                reader.path(), name, std::to_string(numbers_.size()) + " numbers", "a multiple of " + std::to_string(width));
        }
    }

    std::size_t size() const { return numbers_.size() / width_; }
    double operator()(std::size_t row, std::size_t column) const { return numbers_[row * width_ + column]; }
    Vector2 vector(std::size_t row, std::size_t column) const { return {(*this)(row, column), (*this)(row, column + 1)}; }

private:
    std::vector<double> numbers_;
    std::size_t width_;
};

std::vector<Vector2> takeVectors(CheckpointReader& reader, const std::string& name)
{
    const Rows rows(reader, name, 2);
    std::vector<Vector2> vectors;
    for (std::size_t i = 0; i < rows.size(); ++i)
    {
        vectors.push_back(rows.vector(i, 0));
    }
    return vectors;
}

void addContacts(CheckpointWriter& writer, const std::vector<Contact<2>>& contacts)
{
    std::vector<std::int32_t> keys;
    std::vector<double> numbers;
    for (const Contact<2>& c : contacts)
    {
        keys.insert(keys.end(), {c.first, c.second, c.place, c.shift.first, c.shift.second, c.pieces.onA, c.pieces.onB});
        numbers.insert(
            numbers.end(), {c.depth, c.normal.x(), c.normal.y(), c.turn, c.point.x(), c.point.y(), c.force.x(), c.force.y()});
    }
    writer.add("contactKeys", keys);
    writer.add("contacts", numbers);
}

std::vector<Contact<2>> takeContacts(CheckpointReader& reader)
{
    const std::vector<std::int32_t> keys = reader.take<std::int32_t>("contactKeys");
    const Rows rows(reader, "contacts", 8);
    constexpr std::size_t keyWidth = 7;
    if (keys.size() != keyWidth * rows.size())
    {
        throw SetupError(
            reader.path(), "contactKeys", std::to_string(keys.size()) + " numbers", std::to_string(keyWidth * rows.size()));
    }
    std::vector<Contact<2>> contacts;
    for (std::size_t i = 0; i < rows.size(); ++i)
    {
        const std::int32_t* key = &keys[keyWidth * i];
        Contact<2> contact{{key[0], key[1], static_cast<std::int8_t>(key[2]), {key[3], key[4]}}};
        contact.pieces = {static_cast<std::uint8_t>(key[5]), static_cast<std::uint8_t>(key[6])};
        contact.depth = rows(i, 0);
        contact.normal = rows.vector(i, 1);
        contact.turn = static_cast<float>(rows(i, 3));
        contact.point = rows.vector(i, 4);
        contact.force = rows.vector(i, 6);
        contacts.push_back(contact);
    }
    return contacts;
}

void addWalls(CheckpointWriter& writer, const WorldState& state)
{
    writer.add("wallPoints", flat(state.wallPoints));
    writer.add("wallPointsAtSearch", flat(state.wallPointsAtSearch));
    std::vector<double> numbers;
    for (const WallState& w : state.wallStates)
    {
        numbers.insert(
            numbers.end(), {w.velocity.x(), w.velocity.y(), w.force.x(), w.force.y(), w.stiffness, w.damping, w.work});
    }
    writer.add("wallStates", numbers);
}

std::vector<WallState> takeWallStates(CheckpointReader& reader)
{
    const Rows rows(reader, "wallStates", 7);
    std::vector<WallState> states;
    for (std::size_t i = 0; i < rows.size(); ++i)
    {
        states.push_back({rows.vector(i, 0), rows.vector(i, 2), rows(i, 4), rows(i, 5), rows(i, 6)});
    }
    return states;
}

void addLedger(CheckpointWriter& writer, const std::optional<EnergyLedger>& ledger)
{
    std::vector<double> numbers;
    if (ledger)
    {
        numbers = {ledger->start, ledger->gravity, ledger->walls, ledger->external, ledger->contacts, ledger->localDamping,
                   ledger->viscousDamping};
    }
    writer.add("energyLedger", numbers);
}

std::optional<EnergyLedger> takeLedger(CheckpointReader& reader)
{
    const Rows rows(reader, "energyLedger", 7);
    if (rows.size() == 0)
    {
        return std::nullopt;
    }
    return EnergyLedger{rows(0, 0), rows(0, 1), rows(0, 2), rows(0, 3), rows(0, 4), rows(0, 5), rows(0, 6)};
}

} // namespace

void addState(CheckpointWriter& writer, const WorldState& state)
{
    writer.add("worldTime", std::vector<double>{state.time});
    writer.add("position", flat(state.position));
    writer.add("angle", state.angle);
    writer.add("direction", flat(state.direction));
    writer.add("velocity", flat(state.velocity));
    writer.add("angularVelocity", state.angularVelocity);
    writer.add("force", flat(state.force));
    writer.add("torque", state.torque);
    writer.add("inverseMass", state.inverseMass);
    writer.add("inverseInertia", state.inverseInertia);
    writer.add("positionsAtSearch", flat(state.positionsAtSearch));
    writer.add("anglesAtSearch", state.anglesAtSearch);
    addContacts(writer, state.contacts);
    writer.add("springs", state.springs);
    writer.add("turns", state.turns);
    writer.add("radii", state.radii);
    addWalls(writer, state);
    writer.add("cell", flat(state.cell));
    addLedger(writer, state.ledger);
}

WorldState takeState(CheckpointReader& reader)
{
    WorldState state;
    const Rows time(reader, "worldTime", 1);
    state.time = time.size() > 0 ? time(0, 0) : 0;
    state.position = takeVectors(reader, "position");
    state.angle = reader.take<double>("angle");
    state.direction = takeVectors(reader, "direction");
    state.velocity = takeVectors(reader, "velocity");
    state.angularVelocity = reader.take<double>("angularVelocity");
    state.force = takeVectors(reader, "force");
    state.torque = reader.take<double>("torque");
    state.inverseMass = reader.take<double>("inverseMass");
    state.inverseInertia = reader.take<double>("inverseInertia");
    state.positionsAtSearch = takeVectors(reader, "positionsAtSearch");
    state.anglesAtSearch = reader.take<double>("anglesAtSearch");
    state.contacts = takeContacts(reader);
    state.springs = reader.take<double>("springs");
    state.turns = reader.take<double>("turns");
    state.radii = reader.take<double>("radii");
    state.wallPoints = takeVectors(reader, "wallPoints");
    state.wallPointsAtSearch = takeVectors(reader, "wallPointsAtSearch");
    state.wallStates = takeWallStates(reader);
    state.cell = takeVectors(reader, "cell");
    state.ledger = takeLedger(reader);
    return state;
}

} // namespace chesil
