using System;
using System.Numerics;
using CreatureGen.Motion.Walking.Legs;

namespace CreatureGen.Motion.Walking.Footsteps;

/// <summary>Where a foot is on its way at present: where it stands, or between where it left the ground and where it comes down. The leg has to bring it there. Who poses feet writes it.</summary>
internal struct FootPath
{
    /// <summary>Rise of a way, as part of its length, from which on it is taken for a wall that is climbed.</summary>
    private const float Steepest = 1f;

    /// <summary>Place under the ball in model space at present, the swing's lift not counted.</summary>
    public Vector3 Base;

    /// <summary>Where it left the ground and where it comes down, under the ball in model space at present; both where it stands.</summary>
    public Vector3 Start;
    public Vector3 End;

    /// <summary>What of its height above that place is for what stands in its way, metres.</summary>
    public float Over;

    /// <summary>Height above that place, metres.</summary>
    public float Lift;

    /// <summary>Heading in model space at present.</summary>
    public Quaternion Heading;

    /// <summary>The same without what it turns along as its leg is swept: that in which it was set down.</summary>
    public Quaternion Planned;

    /// <summary>Normal of the ground in model space at present.</summary>
    public Vector3 Normal;

    /// <summary>Its pitch, fold and load, without a jump where it leaves the cycle.</summary>
    public PostureFade Posture;

    /// <summary>Whether it was in its swing when it was posed last.</summary>
    public bool Swung;

    /// <summary>By how much it has rolled down in the update in which it came down, radians, toes down; 0 in all others.</summary>
    public float RolledDown;

    /// <summary>How far its leg lies over about the line from hip to foot for an act, radians, the knee ahead.</summary>
    public float Lean;

    /// <summary>How far an act has taken it off the ground, 0..1: then it neither carries nor steps.</summary>
    public float Taken;

    /// <summary>How far an act holds it in the air, 0..1: nothing of its sole has to lie on the ground then. That of a leg that is folded under the body does lie there.</summary>
    public float Aloft;

    /// <summary>Direction away from the straight line on which it goes, upright where that is level; its height is 1, so that its product with a way is how much higher that ends above the line.</summary>
    public readonly Vector3 Away
    {
        get
        {
            Vector3 way = End - Start;
            float level = (float)Math.Sqrt((way.X * way.X) + (way.Z * way.Z));
            if (way.Y == 0f || level == 0f)
            {
                return Vector3.UnitY;
            }

            float rise = Math.Max(-Steepest, Math.Min(way.Y / level, Steepest)) / level;
            return new Vector3(-way.X * rise, 1f, -way.Z * rise);
        }
    }
}
