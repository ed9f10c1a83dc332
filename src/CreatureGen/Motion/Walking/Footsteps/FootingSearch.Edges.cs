using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Walking.Legs;

namespace CreatureGen.Motion.Walking.Footsteps;

/// <content>How feet keep off edges and out of walls: of some places along the foot the one is taken that costs least.</content>
internal sealed partial class FootingSearch
{
    /// <summary>Places to either side at which a foot is off edges are looked for.</summary>
    private const int Looks = 5;

    /// <summary>How far a foot is shifted for an end that would be in a wall, for one that hangs, for long toes that hang by more than half, so that nothing but their root stands, for a wall right before its toes, for a leg length beyond what its leg reaches, and for one from where it went before as its swing ends; leg lengths.</summary>
    private const float WallCost = 0.5f;
    private const float HangCost = 0.12f;
    private const float HalfHangCost = 0.25f;
    private const float NearWallCost = 0.07f;
    private const float BeyondCost = 2.5f;
    private const float LateCost = 1.5f;

    /// <summary>Part of a stance in which its leg has to reach where it stands still.</summary>
    private const float LateStance = 0.7f;

    /// <summary>How much more a leg length counts by which a hip that comes to its end keeps a foot off its place: it comes down beside it.</summary>
    private const float KeptFactor = 4f;

    /// <summary>How far a hip goes up and down in its gait, leg lengths.</summary>
    private const float Bounce = 0.1f;

    /// <summary>Part of a stance in which the body comes over the foot.</summary>
    private const float ComingOver = 0.35f;

    /// <summary>How far feet of legs out to the side, which sweep less far, are shifted along themselves at most, leg lengths; others by their length.</summary>
    private const float LateralShift = 0.1f;

    /// <summary>How far a foot is shifted along itself from where it wants to go, to be off edges and out of walls, metres.</summary>
    /// <param name="step">The moment.</param>
    /// <param name="leg">Whose foot.</param>
    /// <param name="foot">That foot.</param>
    /// <param name="before">The place on the ground to which it went before, world space; null where it has none yet.</param>
    /// <param name="flight">Seconds until it comes down.</param>
    /// <param name="wanted">Under the ball, model space; its height does not count.</param>
    /// <param name="home">Where that is under the body in the middle of the stance, model space.</param>
    /// <param name="yaw">Heading of the foot there, radians from the body's.</param>
    public float OffEdges(in StepContext step, int leg, in Foot foot, Vector3? before, float flight, Vector3 wanted, Vector3 home, float yaw)
    {
        if (step.Ground is IPlaneGround)
        {
            return 0f;
        }

        LegRig shape = body.Legs[leg];
        Vector3 ahead = Ahead(yaw);
        Sole laid = LaidOut(shape, home, ahead);
        float length = shape.Fore + shape.Aft;
        float max = shape.Lateral ? Math.Min(length, LateralShift * shape.Length) : length;
        float late = LateCost * foot.Plan.Swing * foot.Plan.Swing / (shape.Length * step.Frame.Scale);
        float best = 0f;
        float least = float.MaxValue;

        // The nearest places first, behind before ahead.
        for (int look = 0; look <= 2 * Looks; look++)
        {
            float shift = (look + 1) / 2 * max / Looks * ((look & 1) == 0 ? 1f : -1f);
            float cost = Math.Abs(shift) / shape.Length;
            if (cost >= least)
            {
                break;
            }

            Vector3 target = wanted + (ahead * shift);
            if (!Down(step, target, out GroundHit hit))
            {
                continue;
            }

            Sole sole = laid;
            Feel(step, shape, target, hit, ref sole);
            float ends = Cost(sole);
            if (look == 0 && ends == 0f)
            {
                break;
            }

            cost += ends + (BeyondCost * Beyond(step, shape, foot, flight, hit) / shape.Length) + (before is Vector3 earlier ? late * Vec.Distance(hit.Point, earlier) : 0f);
            (best, least) = cost < least ? (shift, cost) : (best, least);
        }

        return best;
    }

    private static float Cost(in Sole sole)
    {
        float near = sole.Toes != SoleEnd.Wall && sole.Before == SoleEnd.Wall ? NearWallCost : 0f;
        return Cost(sole.Toes) + Cost(sole.Middle, HalfHangCost) + Cost(sole.Heel) + near;
    }

    private static float Cost(SoleEnd end, float hangs = HangCost) => end switch { SoleEnd.Wall => WallCost, SoleEnd.Hangs => hangs, _ => 0f };

    /// <summary>How far a place is beyond what a leg reaches as its foot comes down there and late in the stance, and beyond what a hip above it turns to as it comes down and as the body comes over it, metres.</summary>
    private float Beyond(in StepContext step, LegRig shape, in Foot foot, float flight, in GroundHit hit)
    {
        Vector3 place = step.Frame.ToModel(hit.Point);
        float stance = step.Moving ? step.Clock.Duty / step.Clock.Frequency : 0f;
        float beyond = Beyond(step, shape, foot, flight, place) + Beyond(step, shape, foot, flight + (LateStance * stance), place);
        return shape.Lateral ? beyond : beyond + (KeptFactor * (Kept(step, shape, foot, flight, place) + Kept(step, shape, foot, flight + (ComingOver * stance), place)));
    }

    private float Beyond(in StepContext step, LegRig shape, in Foot foot, float seconds, Vector3 place)
    {
        place = Then(step, seconds, place);

        // Seen from a hip at its height at rest; on a slope those of a long trunk are far from there.
        float raised = foot.Leg.Hip.Y - shape.HipRest.Y;
        place.Y -= shape.Lateral ? 0f : raised - Scalar.Clamp(raised, -Bounce * shape.Length, Bounce * shape.Length);
        return Vec.Distance(LandingRange.Within(body, shape, foot.Leg, step.RootVelocity, seconds, place), place);
    }

    private float Kept(in StepContext step, LegRig shape, in Foot foot, float seconds, Vector3 place) =>
        LandingRange.Kept(body, shape, foot.Leg, step.RootVelocity, seconds, Then(step, seconds, place));

    /// <summary>A place as it is seen when the body has gone up or down the slope for a time.</summary>
    private static Vector3 Then(in StepContext step, float seconds, Vector3 place)
    {
        place.Y -= step.Slope * step.RootVelocity.Predict(seconds, out _).Z;
        return place;
    }
}
