using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Seeding;

namespace CreatureGen.Motion.Metrics;

/// <summary>A run of a creature that is measured: from standing straight ahead in one movement until it has settled, then for some cycles under the eyes of a <see cref="MotionRecorder"/>. The same trial gives the same figures.</summary>
/// <param name="Movement">What the creature does.</param>
/// <param name="Relief">What it goes on.</param>
/// <param name="Hertz">Updates per second, 4..1000.</param>
public sealed record MotionTrial(Movement Movement, GroundRelief Relief, float Hertz)
{
    /// <summary>Seconds before anything is measured: speed, gait and springs have come to rest by then.</summary>
    public const float SettleSeconds = 3f;

    /// <summary>Cycles that are measured.</summary>
    public const int Cycles = 3;

    private const float MinSeconds = 0.5f;
    private const float MaxSeconds = 6f;

    /// <summary>Part of its length that the hills take for the leg of a creature without legs.</summary>
    private const float LegOfLegless = 0.16f;

    private static readonly float[] rates = { 30f, 60f, 144f };

    /// <summary>Every movement of a creature but standing, on each ground, at 30, 60 and 144 Hz.</summary>
    /// <exception cref="ArgumentNullException">There is no profile.</exception>
    public static IEnumerable<MotionTrial> Of(MotionProfile profile)
    {
        foreach (Movement movement in Movement.OfGoing(profile))
        {
            if (!movement.IsCyclic)
            {
                continue;
            }

            foreach (GroundRelief relief in new[] { GroundRelief.Flat, GroundRelief.Rough })
            {
                foreach (float hertz in rates)
                {
                    yield return new MotionTrial(movement, relief, hertz);
                }
            }
        }
    }

    /// <summary>Runs it.</summary>
    /// <param name="profile">The creature's, from which the movement is.</param>
    /// <exception cref="ArgumentException">The rate is out of its range, or the movement is none of the creature's.</exception>
    public MotionReport Run(MotionProfile profile)
    {
        if (profile == null)
        {
            throw new ArgumentNullException(nameof(profile));
        }

        Finite.RequireWithin(Hertz, 4f, 1000f, nameof(Hertz));
        float step = 1f / Hertz;
        IGround ground = Relief == GroundRelief.Flat ? FlatGround.Level : Hills(profile);
        CreatureAnimator animator = Movement.Begin(profile, ground);
        for (int i = 0; i < SettleSeconds * Hertz; i++)
        {
            animator.Update(step, Movement.Input, ground);
        }

        var recorder = new MotionRecorder(animator);

        // Fliers beat their wings and glide in turn: a cycle is both.
        int beats = Movement.Input.Medium == MotionMedium.Air && profile.Flight != null ? profile.Flight.BeatsPerCycle : 1;
        float seconds = animator.Frequency > 0f ? Scalar.Clamp(Cycles * beats / animator.Frequency, MinSeconds, MaxSeconds) : MaxSeconds;
        int frames = 2 + (int)(seconds * Hertz);
        for (int i = 0; i < frames; i++)
        {
            animator.Update(step, Movement.Input, ground);
            recorder.Record(step, ground);
        }

        return recorder.Report();
    }

    /// <summary>Length that hills are measured by, metres: of the legs, or a part of the body's for what is not done on legs.</summary>
    internal static float HillLength(MotionProfile profile, Movement movement)
    {
        (Vector3 min, Vector3 max) = Extent(profile.Subject);
        return movement.Gait != null ? profile.LegLength : LegOfLegless * (max.Z - min.Z);
    }

    /// <summary>Corners of the box around the joints at rest.</summary>
    internal static (Vector3 Min, Vector3 Max) Extent(MotionSubject subject)
    {
        Vector3 min = subject.Skeleton.ModelPositions[0];
        Vector3 max = min;
        foreach (Vector3 joint in subject.Skeleton.ModelPositions)
        {
            min = Vec.Min(min, joint);
            max = Vec.Max(max, joint);
        }

        return (min, max);
    }

    private HeightFieldGround Hills(MotionProfile profile)
    {
        float length = HillLength(profile, Movement);
        (Vector3 min, Vector3 max) = Extent(profile.Subject);
        float way = Math.Abs(Movement.Input.Speed) * (SettleSeconds + MaxSeconds + 1f);

        // Creatures without legs wind: some of them lie across their way.
        float room = Movement.Gait != null ? 3f * length : Math.Max(3f * length, max.Z - min.Z);
        return new HillField(new Seed(profile.Subject.Seed), length).Around(max.X + room, min.Z - room - (0.2f * way), max.Z + room + way);
    }
}
