using System;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Metrics.Courses;

/// <summary>The ground of a course in the world at a moment: what lies where, and how it moves.</summary>
internal class CourseSurface
{
    /// <summary>In how many steps the way out is looked for.</summary>
    private const int WaySteps = 16;

    /// <summary>Metres above which there is no ground.</summary>
    private const float Highest = 1e3f;

    private static readonly Vector3[] levelWays = { Vector3.UnitZ, -Vector3.UnitZ, Vector3.UnitX, -Vector3.UnitX };

    public CourseSurface(IGround ground) => Ground = ground;

    /// <summary>As creatures feel it.</summary>
    public IGround Ground { get; }

    /// <summary>The axes that go along with it.</summary>
    public virtual RootPlace Frame => RootPlace.Identity;

    /// <summary>Whether up is the Y axis everywhere.</summary>
    public virtual bool IsLevel => true;

    /// <summary>Which way is up for who is at a place.</summary>
    /// <param name="place">World space.</param>
    public virtual Vector3 UpAt(Vector3 place) => Vector3.UnitY;

    /// <summary>The ground below a place, looked for from above the highest hill; null where there is none.</summary>
    /// <param name="place">World space.</param>
    public virtual Vector3? Below(Vector3 place) => Ground.Cast(place with { Y = Highest }, -Vector3.UnitY, 2f * Highest, out GroundHit hit) ? hit.Point : null;

    /// <summary>Moves on.</summary>
    /// <param name="seconds">Since the last time.</param>
    public virtual void Advance(double seconds)
    {
    }

    /// <summary>The height of the ground at a place, looked for from far above.</summary>
    /// <param name="place">World space; its height only says around where.</param>
    /// <param name="reach">How far above and below, metres.</param>
    /// <returns>Metres; null where there is none.</returns>
    public float? HeightAt(Vector3 place, float reach) =>
        Ground.Cast(place + (Vector3.UnitY * reach), -Vector3.UnitY, 2f * reach, out GroundHit hit) ? hit.Point.Y : null;

    /// <summary>How deep a place is in the ground: the shortest way out of it, up or level ahead, back or aside. What is just inside a riser is hardly in it.</summary>
    /// <param name="place">World space.</param>
    /// <param name="below">How far it is below the ground above it, metres.</param>
    /// <param name="reach">How far above and below ground is looked for, metres.</param>
    public float DepthOf(Vector3 place, float below, float reach)
    {
        float depth = below;
        for (int i = 0; i < levelWays.Length; i++)
        {
            for (int k = 1; k < WaySteps; k++)
            {
                float way = below * k / WaySteps;
                if (way >= depth)
                {
                    break;
                }

                // What is left to go up from there counts as well.
                float left = HeightAt(place + (levelWays[i] * way), reach) is float height ? height - place.Y : 0f;
                depth = Math.Min(depth, Math.Max(way, left));
            }
        }

        return depth;
    }
}

/// <summary>A platform without edges: it rises and sinks, goes to and fro and turns to and fro, each at a pace of its own.</summary>
internal sealed class LiftSurface : CourseSurface
{
    private readonly Platform platform;
    private readonly float legLength;
    private double seconds;

    public LiftSurface(float legLength)
        : this(new Platform(), legLength)
    {
    }

    private LiftSurface(Platform platform, float legLength)
        : base(platform)
    {
        this.platform = platform;
        this.legLength = legLength;
    }

    public override RootPlace Frame => platform.Place;

    public override void Advance(double step)
    {
        seconds += step;
        var position = new Vector3((float)Wave(1.3, 0.9), (float)Wave(0.8, 1.4), (float)Wave(0.9, 0.5));
        platform.Place = new RootPlace(position * legLength, Rotation.FromAxisAngle(Vector3.UnitY, Wave(0.6, 0.7)));
    }

    /// <summary>A swing about 0, begun at rest.</summary>
    private double Wave(double width, double pace) => 0.5 * width * (1 - PortableMath.Cos(pace * seconds));

    private sealed class Platform : IMovingGround
    {
        private const int Number = 1;

        public RootPlace Place { get; set; } = RootPlace.Identity;

        public bool Cast(Vector3 origin, Vector3 direction, float distance, out GroundHit hit)
        {
            bool found = FlatGround.Level.Cast(origin - Place.Position, direction, distance, out GroundHit level);
            hit = level with { Point = level.Point + Place.Position, Platform = Number };
            return found;
        }

        public bool TryLocate(int platform, out RootPlace placement)
        {
            placement = Place;
            return platform == Number;
        }
    }
}
