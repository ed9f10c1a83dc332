using CreatureGen.Motion;
using Godot;

namespace CreatureGen.GodotAddon;

/// <summary>The bodies of the scene as ground to walk on. To be asked within a frame of the physics.</summary>
public sealed class SpaceGround : IGround
{
    private readonly PhysicsDirectSpaceState3D space;
    private readonly uint mask;

    public SpaceGround(PhysicsDirectSpaceState3D space, uint mask) => (this.space, this.mask) = (space, mask);

    public bool Cast(System.Numerics.Vector3 origin, System.Numerics.Vector3 direction, float distance, out GroundHit hit)
    {
        PhysicsRayQueryParameters3D ray = PhysicsRayQueryParameters3D.Create(GodotSpace.Point(origin), GodotSpace.Point(origin + (direction * distance)), mask);
        Godot.Collections.Dictionary met = space.IntersectRay(ray);
        if (met.Count == 0)
        {
            hit = default;
            return false;
        }

        hit = new GroundHit(GodotSpace.Point(met["position"].AsVector3()), GodotSpace.Point(met["normal"].AsVector3()));
        return true;
    }
}
