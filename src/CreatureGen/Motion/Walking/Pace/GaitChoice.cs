using System.Collections.Generic;
using CreatureGen.Anatomy;
using CreatureGen.Motion.Walking.Bodies;

namespace CreatureGen.Motion.Walking.Pace;

/// <summary>Which gaits a creature has by its build: data.</summary>
internal static class GaitChoice
{
    /// <summary>Kilograms below which quadrupeds bound instead of galloping.</summary>
    private const float BoundingMass = 2f;

    /// <summary>Kilograms above which nobody gallops.</summary>
    private const float HeaviestGallop = 2500f;

    /// <summary>Legs longer than this part of the trunk get into each other's way in a trot: camels pace.</summary>
    private const float PacingLegs = 1.5f;

    /// <summary>Part of a gait's comfortable Froude number below which it is not entered.</summary>
    private const float Shuffling = 0.25f;

    /// <summary>How much faster it has to be than where it is entered.</summary>
    private const float WorthIt = 1.02f;

    /// <summary>How much quicker than its mass lets them its steps may come where one gait is left for the next.</summary>
    private const float MaxHurry = 1.4f;

    /// <summary>The gaits of a body, slow to fast.</summary>
    public static GaitSet For(LeggedBody body, float gravity)
    {
        var steps = new List<GaitStep>();
        BodyPlan plan = body.Subject.Plan;
        if (body.Waddles)
        {
            steps.Add(new GaitStep(GaitLibrary.Waddle, 0f, 0f));
            steps.Add(new GaitStep(GaitLibrary.WaddleRun, 0.22f, 0.15f));
        }
        else if (body.Rows == 1)
        {
            steps.Add(new GaitStep(GaitLibrary.BipedWalk, 0f, 0f));
            steps.Add(body.Hops ? new GaitStep(GaitLibrary.Hop, 0.40f, 0.28f) : new GaitStep(GaitLibrary.BipedRun, 0.50f, 0.36f));
        }
        else if (body.Rows > 2 && (body.Sprawls || plan == BodyPlan.Sprawling))
        {
            steps.Add(new GaitStep(WaveOf(body), 0f, 0f));
            steps.Add(body.Leaps ? new GaitStep(GaitLibrary.Leap, 0.15f, 0.09f) : new GaitStep(GaitLibrary.Tripod, 0.45f, 0.33f));
        }
        else if (plan == BodyPlan.Sprawling || body.Sprawls)
        {
            steps.Add(new GaitStep(GaitLibrary.Crawl, 0f, 0f));
            steps.Add(body.Leaps ? new GaitStep(GaitLibrary.Leap, 0.15f, 0.09f) : new GaitStep(GaitLibrary.SprawlTrot, 0.35f, 0.25f));
        }
        else if (plan == BodyPlan.Columnar)
        {
            steps.Add(new GaitStep(WalkOf(body), 0f, 0f));
            steps.Add(new GaitStep(GaitLibrary.Amble, 0.22f, 0.15f));
        }
        else
        {
            steps.Add(new GaitStep(WalkOf(body), 0f, 0f));
            bool paces = body.LegLength > PacingLegs * body.TrunkLength;
            steps.Add(new GaitStep(paces ? GaitLibrary.Pace : GaitLibrary.Trot, 0.35f, 0.25f));
            if (body.Mass < BoundingMass)
            {
                steps.Add(new GaitStep(GaitLibrary.Bound, 1.8f, 1.3f));
            }
            else if (body.Mass < HeaviestGallop)
            {
                steps.Add(new GaitStep(GaitLibrary.Canter, 1.6f, 1.2f));
                steps.Add(new GaitStep(plan is BodyPlan.Digitigrade ? GaitLibrary.RotaryGallop : GaitLibrary.TransverseGallop, 2.6f, 2.1f));
            }
        }

        return Kept(steps, body, gravity);
    }

    /// <summary>Four legs walk in four beats; more legs one behind the other, the wave running ahead.</summary>
    private static Gait WalkOf(LeggedBody body) => body.Rows > 2 ? GaitLibrary.Wave : GaitLibrary.Walk;

    /// <summary>Waves of three pairs run ahead, as in insects; those of more pairs the way in which neighbouring feet leave each other the longer stances.</summary>
    private static Gait WaveOf(LeggedBody body) =>
        body.Rows > 3 && SlopeStance.OnLevel(body, GaitLibrary.BackwardWave) > SlopeStance.OnLevel(body, GaitLibrary.Wave) ? GaitLibrary.BackwardWave : GaitLibrary.Wave;

    /// <summary>
    /// The set without gaits that the creature's legs are too short or too slow for: in which it gets hardly faster than where they are entered, or which steps too quick lead to or go on in. Where the
    /// gait before one that is kept ends before that, because its steps would come too quick, the next is entered there.
    /// </summary>
    private static GaitSet Kept(List<GaitStep> steps, LeggedBody body, float gravity)
    {
        float quickest = GaitSet.QuickestOf(body.Mass);
        var kept = new List<GaitStep> { steps[0] };
        GaitSet set = SetOf();
        for (int i = 1; i < steps.Count; i++)
        {
            float before = set.TopSpeed;
            float reached = System.Math.Max(before * before / (gravity * body.LegLength), Shuffling * steps[i].Gait.Comfortable);
            float fraction = System.Math.Min(reached / steps[i].Enter, 1f);
            GaitStep next = steps[i] with { Enter = fraction * steps[i].Enter, Leave = fraction * steps[i].Leave };
            bool hurries = Hurries(kept[kept.Count - 1].Gait, next.Enter) || Hurries(next.Gait, next.Leave);
            kept.Add(next);
            GaitSet longer = SetOf();
            if (!hurries && longer.TopSpeed > WorthIt * System.Math.Min(before, (float)System.Math.Sqrt(steps[i].Enter * gravity * body.LegLength)))
            {
                set = longer;
            }
            else
            {
                kept.RemoveAt(kept.Count - 1);
            }
        }

        return set;

        GaitSet SetOf() => new GaitSet(kept, body.LegLength, body.Mass, gravity, gait => SlopeStance.OnLevel(body, gait));

        bool Hurries(Gait gait, float froude) =>
            GaitSet.FrequencyOf(gait, froude, body.LegLength, gravity, SlopeStance.OnLevel(body, gait), quickest) > MaxHurry * quickest;
    }
}
