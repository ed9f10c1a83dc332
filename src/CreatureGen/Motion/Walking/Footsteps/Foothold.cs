using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Walking.Footsteps;

/// <summary>A place on the ground for a foot. World space, metres; on a moving platform it goes with it.</summary>
internal struct Foothold
{
    /// <summary>Under the ball.</summary>
    public Vector3 Position;

    /// <summary>Turn of the foot from the model's axes at rest, about up.</summary>
    public Quaternion Heading;

    /// <summary>Unit normal of the ground.</summary>
    public Vector3 Normal;

    /// <summary>What the ground is made of.</summary>
    public int Surface;

    /// <summary>The platform that it is on, 0 for none.</summary>
    public int Platform;

    /// <summary>Whether its toes hang over an edge: it hardly rolls over them.</summary>
    public bool Overhangs;

    /// <summary>Whether its toes meet a wall.</summary>
    public bool MeetsWall;

    private Vector3 localPosition;
    private Quaternion localHeading;
    private Vector3 localNormal;

    /// <summary>Yaw of the foot from the heading of a body, radians, small angles.</summary>
    public readonly float YawFrom(in RootPlace body)
    {
        Quaternion rotation = Rotation.Multiply(Rotation.Inverse(body.Rotation), Heading);
        return 2f * (rotation.W < 0f ? -rotation.Y : rotation.Y);
    }

    /// <summary>Takes note of where the place is on its platform.</summary>
    public void Attach(IMovingGround? ground)
    {
        if (Platform == 0 || ground == null || !ground.TryLocate(Platform, out RootPlace at))
        {
            Platform = 0;
            return;
        }

        Quaternion inverse = Rotation.Inverse(at.Rotation);
        localPosition = at.ToModel(Position);
        localHeading = Rotation.Multiply(inverse, Heading);
        localNormal = Rotation.Rotate(inverse, Normal);
    }

    /// <summary>Goes with the platform to where it is now.</summary>
    public void Follow(IMovingGround ground)
    {
        if (Platform == 0)
        {
            return;
        }

        if (!ground.TryLocate(Platform, out RootPlace at))
        {
            Platform = 0;
            return;
        }

        Position = at.ToWorld(localPosition);
        Heading = Rotation.Normalize(Rotation.Multiply(at.Rotation, localHeading));
        Normal = Rotation.Rotate(at.Rotation, localNormal);
    }
}
