using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Motion;
using CreatureGen.Motion.Metrics;
using CreatureGen.Sampling;
using CreatureGen.Tests.Creatures;
using CreatureGen.Tests.Sampling;

namespace CreatureGen.Tests.Motion;

/// <summary>Animals to walk with: bounds on motion were measured on these.</summary>
internal static class Walkers
{
    /// <summary>Walking animals.</summary>
    public static CreatureOptions Options { get; } = CreatureOptions.Default with { Kind = RequestedKind.Walking, Strangeness = 0 };

    /// <summary>A walking animal of a seed, of the seed's size.</summary>
    public static Creature Any(ulong seed) => GrownCreatures.Of(seed, SizeOfSeed.In(Options, seed));

    /// <summary>The walking animals of seeds below a count that have a plan; the others are not grown.</summary>
    public static IEnumerable<(ulong Seed, Creature Creature)> WithPlan(BodyPlan plan, int count)
    {
        for (ulong seed = 0; seed < (ulong)count; seed++)
        {
            CreatureBlueprint blueprint = BlueprintSampler.Sample(seed, SizeOfSeed.In(Options, seed));
            if (blueprint.Plan == plan)
            {
                yield return (seed, CreatureGenerator.Build(blueprint));
            }
        }
    }

    /// <summary>An animal of a plan, of the seed's size.</summary>
    public static Creature Of(BodyPlan plan, ulong seed) => GrownCreatures.Of(seed, SizeOfSeed.In(CreatureOptions.Default with
    {
        BodyPlans = BodyPlanWeight.Only(plan),
        Strangeness = 0,
    }, seed));

    /// <summary>Lets an animator go for a time.</summary>
    public static void Run(CreatureAnimator animator, float seconds, float rate, MotionInput input, IGround ground)
    {
        int frames = (int)Math.Round(seconds * rate);
        for (int i = 0; i < frames; i++)
        {
            animator.Update(1f / rate, input, ground);
        }
    }

    /// <summary>Lets an animator go for some frames and measures how well it does.</summary>
    public static MotionReport Measure(CreatureAnimator animator, int frames, float rate, MotionInput input, IGround ground)
    {
        var recorder = new MotionRecorder(animator);
        for (int i = 0; i < frames; i++)
        {
            animator.Update(1f / rate, input, ground);
            recorder.Record(1f / rate, ground);
        }

        return recorder.Report();
    }
}

/// <summary>Smooth hills, so high and steep as a leg length makes them.</summary>
internal sealed class Hills : IGround
{
    private readonly float length;
    private readonly float height;

    public Hills(float legLength, float fraction)
    {
        length = legLength;
        height = fraction * legLength;
    }

    public float At(float x, float z) => height * 0.4f * (MathF.Sin((x / length * 2.1f) + 1f) + MathF.Sin(z / length * 3.3f) + MathF.Sin(((x * 1.3f) + (z * 2.2f)) / length));

    public bool Cast(Vector3 origin, Vector3 direction, float distance, out GroundHit hit)
    {
        float y = At(origin.X, origin.Z);
        if (origin.Y - y > distance)
        {
            hit = default;
            return false;
        }

        float e = 0.01f * length;
        var normal = Vector3.Normalize(new Vector3(-(At(origin.X + e, origin.Z) - At(origin.X - e, origin.Z)) / (2 * e), 1f, -(At(origin.X, origin.Z + e) - At(origin.X, origin.Z - e)) / (2 * e)));
        hit = new GroundHit(new Vector3(origin.X, y, origin.Z), normal);
        return true;
    }
}

/// <summary>A lift that goes up and sideways and turns.</summary>
internal sealed class Lift : IMovingGround
{
    public RootPlace Place { get; set; } = RootPlace.Identity;

    public bool Cast(Vector3 origin, Vector3 direction, float distance, out GroundHit hit)
    {
        float y = Place.Position.Y;
        hit = new GroundHit(new Vector3(origin.X, y, origin.Z), Vector3.UnitY, 3, 7);
        return origin.Y - y <= distance;
    }

    public bool TryLocate(int platform, out RootPlace placement)
    {
        placement = Place;
        return platform == 7;
    }
}
