using System;
using System.Numerics;
using CreatureGen.Seeding;

namespace CreatureGen.Motion.Metrics.Courses;

/// <summary>Lays the grounds of courses for a creature and what it is asked to do.</summary>
internal static class CourseSurfaces
{
    // All in leg lengths.
    private const float Tread = 0.55f;
    private const float Rise = 0.2f;
    private const int StepsOfFlight = 30;
    private const int TreadsOfLanding = 6;
    private const float RampLength = 8f;
    private const float TangentOfRamp = 0.36397f;
    private const float GapLength = 0.4f;
    private const float GapEvery = 2.2f;
    private const float BlockLength = 4f;
    private const float BlockHeight = 0.35f;
    private const float LakeLength = 8f;
    private const float IslandLength = 8f;
    private const float Freeboard = 0.1f;
    private const float PipeRadius = 12f;

    /// <summary>Depth of a lake, parts of the depth at which who goes there floats.</summary>
    private const float LakeDepth = 1.6f;

    /// <summary>Leg lengths of level ground on all sides of who stands there.</summary>
    private const float Room = 4f;

    /// <summary>How much farther than asked anybody gets.</summary>
    private const float Overshoot = 1.25f;

    /// <summary>Lays a ground.</summary>
    /// <param name="ground">Which.</param>
    /// <param name="profile">Whose legs it is measured by.</param>
    /// <param name="script">Says how far the ground must go.</param>
    public static CourseSurface Lay(CourseGround ground, MotionProfile profile, CourseScript script)
    {
        float length = GroundLength(profile);
        return ground switch
        {
            CourseGround.Flat => new CourseSurface(FlatGround.Level),
            CourseGround.Rough => new CourseSurface(new EndlessHills(new Seed(profile.Subject.Seed), length)),
            CourseGround.Lift => new LiftSurface(length),
            CourseGround.Water => new CourseSurface(new WaterGround(Across(profile, script, length, Lake(profile, length)), new Vector3(0f, -Freeboard * length, 0f), Vector3.UnitY)),
            CourseGround.Pipe => new PipeSurface(PipeRadius * length),
            CourseGround.Stones => new CourseSurface(new SteppingStones(new Seed(profile.Subject.Seed).Child("stones"), length, MotionTrial.Extent(profile.Subject).Max.Z + (0.5f * length))),
            _ => new CourseSurface(Across(profile, script, length, Piece(ground, length))),
        };
    }

    /// <summary>Length of checks in pictures of grounds that are not even, metres: steps and ramps end at multiples of it.</summary>
    public static float CheckLength(MotionProfile profile) => Tread * GroundLength(profile);

    /// <summary>Length that grounds are measured by, metres.</summary>
    public static float GroundLength(MotionProfile profile) => profile.Legs != null ? profile.LegLength : MotionTrial.HillLength(profile, Movement.OfGoing(profile)[0]);

    /// <summary>A shore, a bed deeper than it floats, the other shore and an island.</summary>
    private static Action<GroundProfile> Lake(MotionProfile profile, float length)
    {
        float depth = (Freeboard * length) + (LakeDepth * Math.Max(profile.Float?.Draught ?? 0f, length));
        float shore = depth / TangentOfRamp;
        return line => line.Ramp(shore, -depth).Floor(LakeLength * length).Ramp(shore, depth).Floor(IslandLength * length);
    }

    /// <summary>What repeats of a ground that is the same all across.</summary>
    private static Action<GroundProfile> Piece(CourseGround ground, float length) => ground switch
    {
        CourseGround.Stairs => line => line
            .Flight(StepsOfFlight, Tread * length, Rise * length).Floor(TreadsOfLanding * Tread * length)
            .Flight(StepsOfFlight, Tread * length, -Rise * length).Floor(TreadsOfLanding * Tread * length),
        CourseGround.Slope => line => line
            .Ramp(RampLength * length, TangentOfRamp * RampLength * length).Floor(RampLength * length)
            .Ramp(RampLength * length, -TangentOfRamp * RampLength * length).Floor(RampLength * length),
        CourseGround.Gap => line => line.Gap(GapLength * length).Floor((GapEvery - GapLength) * length),
        CourseGround.Platform => line => line.Riser(BlockHeight * length).Floor(BlockLength * length).Riser(-BlockHeight * length).Floor(BlockLength * length),
        _ => throw new ArgumentOutOfRangeException(nameof(ground), ground, "expected a ground of courses"),
    };

    /// <summary>A ground across the Z axis, as long and wide as the script may take the creature, that begins to repeat a piece ahead of it.</summary>
    private static MeshGround Across(MotionProfile profile, CourseScript script, float length, Action<GroundProfile> piece)
    {
        (Vector3 min, Vector3 max) = MotionTrial.Extent(profile.Subject);
        float room = (Room * length) + max.Z - min.Z;
        float ahead = 0f;
        bool turns = false;
        foreach (CourseCommand command in script.Commands)
        {
            ahead += Overshoot * command.Seconds * (Math.Abs(command.Input.Speed) + Math.Abs(command.Input.Sideways));
            turns |= command.Input.YawRate != 0f || command.Input.Sideways != 0f;
        }

        // Whoever turns for a moment may go astray for the rest.
        float aside = turns ? ahead : 0f;
        float foot = (float)Math.Ceiling((max.Z + (0.5f * length)) / (Tread * length)) * Tread * length;
        float start = foot - ((float)Math.Ceiling((foot + room + ahead) / (Tread * length)) * Tread * length);
        return new GroundProfile(room + max.X + aside, start).Floor(foot - start).Until(room + ahead, piece).Floor(room).ToGround();
    }
}
