#pragma once

#include "benchmarks/dryThroughput/scene.hpp"

#include <box2d/box2d.h>

/// Box2D with the scene's polygons between the scene's walls.
namespace chesil::benchmark
{

/// Implicit steps with the iterations that Box2D's manual recommends [s].
constexpr float box2dTimeStep = 1.0F / 60;
constexpr int velocityIterations = 8;
constexpr int positionIterations = 3;

class Box2dBox
{
public:
    explicit Box2dBox(const Scene& scene) : world_(b2Vec2(0, 0))
    {
        world_.SetAllowSleeping(false);
        world_.SetContinuousPhysics(false);
        const Vector2 size = scene.first + scene.second;
        addWall(size / 2 - scene.first, size, Vector2::Zero());
        addWall(size / 2 + scene.first, size, scene.sideVelocity());
        addWall(size / 2 - scene.second, size, Vector2::Zero());
        addWall(size / 2 + scene.second, size, scene.lidVelocity());
        addGrains(scene);
    }

    void run(int steps)
    {
        for (int step = 0; step < steps; ++step)
        {
            world_.Step(box2dTimeStep, velocityIterations, positionIterations);
        }
    }

    double contactsAGrain() const
    {
        double ends = 0;
        for (const b2Contact* contact = world_.GetContactList(); contact; contact = contact->GetNext())
        {
            if (contact->IsTouching())
            {
                ends += isGrain(contact->GetFixtureA()) + isGrain(contact->GetFixtureB());
            }
        }
        return ends / grains_;
    }

private:
    static b2Vec2 inBox2d(const Vector2& v)
    {
        return b2Vec2(static_cast<float>(v.x()), static_cast<float>(v.y()));
    }

    static int isGrain(const b2Fixture* fixture)
    {
        return fixture->GetBody()->GetType() == b2_dynamicBody ? 1 : 0;
    }

    void addTo(b2Body& body, const b2PolygonShape& shape)
    {
        b2FixtureDef fixture;
        fixture.shape = &shape;
        fixture.density = static_cast<float>(sceneDensity);
        fixture.friction = static_cast<float>(friction);
        fixture.restitution = 0;
        body.CreateFixture(&fixture);
    }

    /// A block as big as the box, long enough for corners to stay closed.
    void addWall(const Vector2& centre, const Vector2& size, const Vector2& velocity)
    {
        b2BodyDef definition;
        definition.type = velocity.isZero() ? b2_staticBody : b2_kinematicBody;
        definition.position = inBox2d(centre);
        definition.linearVelocity = inBox2d(velocity);
        b2PolygonShape block;
        block.SetAsBox(static_cast<float>(size.x() / 2) - b2_polygonRadius,
                       static_cast<float>(size.y() / 2) - b2_polygonRadius);
        addTo(*world_.CreateBody(&definition), block);
    }

    void addGrains(const Scene& scene)
    {
        std::vector<b2PolygonShape> polygons;
        for (const NamedShape& named : templatesOf(scene.kind))
        {
            std::vector<b2Vec2> vertices;
            for (const Vector2& vertex :
                 roundedPolygonOf(static_cast<int>(polygons.size()), named.shape, b2_polygonRadius).core)
            {
                vertices.push_back(inBox2d(vertex));
            }
            polygons.emplace_back();
            polygons.back().Set(vertices.data(), static_cast<int>(vertices.size()));
        }
        for (const GrainState& grain : scene.grains)
        {
            b2BodyDef definition;
            definition.type = b2_dynamicBody;
            definition.position = inBox2d(grain.position);
            definition.angle = static_cast<float>(grain.angle);
            definition.linearVelocity = inBox2d(grain.velocity);
            definition.angularVelocity = static_cast<float>(grain.angularVelocity);
            addTo(*world_.CreateBody(&definition), polygons[static_cast<std::size_t>(grain.shape)]);
        }
        grains_ = static_cast<double>(scene.grains.size());
    }

    b2World world_;
    double grains_ = 0;
};

} // namespace chesil::benchmark
