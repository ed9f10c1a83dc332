using System;
using System.Numerics;
using CreatureGen.Anatomy.Legs;
using CreatureGen.Maths;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Motion.Walking.Footsteps;
using CreatureGen.Motion.Walking.Legs;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Walking.Poses;

/// <summary>
/// Bounds how fast joints of legs turn from pose to pose, whatever is asked of them: a leg that cannot follow lags behind all of its joints together, on the way from where it was to where it should be, and its foot knows by how much.
/// One in the air comes after; one that comes down stands where it is; one that stands lets go.
/// </summary>
internal sealed class LegPace
{
    /// <summary>Radians per second: nothing in an animal is faster, and hardly anything in a gait.</summary>
    private const float Fastest = 58f;

    private readonly LeggedBody body;
    private readonly RestRotations turns;
    private readonly LegTurns[] shown;
    private bool known;
    private float seconds;
    private float cosine;

    public LegPace(LeggedBody body, RestRotations turns)
    {
        this.body = body;
        this.turns = turns;
        shown = new LegTurns[body.Legs.Length];
    }

    /// <summary>Asks memory for what was shown.</summary>
    /// <returns>See <see cref="MemoryLines"/>.</returns>
    public int Fetch() => MemoryLines.Touch(shown, body.Legs.Length);

    /// <summary>Takes over what another has shown.</summary>
    public void CopyFrom(LegPace other)
    {
        other.shown.CopyTo(shown, 0);
        (known, seconds, cosine) = (other.known, other.seconds, other.cosine);
    }

    /// <summary>Forgets what was shown: from there to what comes next no time passes.</summary>
    public void Forget() => known = false;

    /// <summary>Takes a pose for what was shown.</summary>
    public void Show(in Pose local)
    {
        known = true;
        for (int i = 0; i < shown.Length; i++)
        {
            shown[i] = LegTurns.Of(body.Legs[i], local);
        }
    }

    /// <summary>Bounds the legs of a pose, and takes it for what is shown. Where no time passes it is as it is.</summary>
    /// <param name="dt">Seconds since the last.</param>
    /// <param name="feet">Their feet, which learn how far they lag.</param>
    /// <param name="local">The pose.</param>
    public void Bound(float dt, Span<Foot> feet, in Pose local)
    {
        if (dt <= 0f)
        {
            return;
        }

        float least = Least(dt);
        for (int i = 0; i < shown.Length; i++)
        {
            LegRig leg = body.Legs[i];
            var asked = LegTurns.Of(leg, local);
            float turned = known ? shown[i].CosineTo(asked) : 1f;
            if (turned < least)
            {
                float half = FastTrigonometry.Of((float)Math.Sqrt((1f - turned) * (1f + turned)), turned);
                shown[i].WriteTowards(asked, 0.5f * Fastest * dt / half, leg, local);
                shown[i] = LegTurns.Of(leg, local);
                if (!feet.IsEmpty)
                {
                    Tell(ref feet[i], End(leg, feet[i], shown[i]) - End(leg, feet[i], asked));
                }
            }
            else
            {
                shown[i] = asked;
            }
        }

        known = true;
    }

    /// <summary>The same where the pose is not that of their feet alone: these learn nothing.</summary>
    public void Bound(float dt, in Pose local) => Bound(dt, default, local);

    /// <summary>Cosine of half the angle by which a joint turns at most; 0 where it may turn by any.</summary>
    private float Least(float dt)
    {
        if (dt != seconds)
        {
            seconds = dt;
            FastTrigonometry.SinCos(Math.Min(0.5f * Fastest * dt, 0.5f * (float)PortableMath.Pi), out _, out cosine);
        }

        return cosine;
    }

    /// <summary>Tells a foot how far it lags.</summary>
    private static void Tell(ref Foot foot, Vector3 way)
    {
        float down = foot.Plan.Arrived && foot.Taken == 0f ? 1f : HipLimit.Of(foot).Arriving;
        foot.Leg.Residual += Vec.Length(way);
        foot.Leg.Astray += way * down;
    }

    /// <summary>Where the leg brings its ankle, or the ball of a linked one, from its hip.</summary>
    private Vector3 End(LegRig leg, in Foot foot, in LegTurns local)
    {
        Quaternion thigh = Rotation.Multiply(foot.Leg.Carrier, turns.Of(leg.Hip, local.Hip));
        Quaternion shank = Rotation.Multiply(thigh, turns.Of(leg.Knee, local.Knee));
        Vector3 ankle = Rotation.Rotate(thigh, leg.Thigh) + Rotation.Rotate(shank, leg.Shank);
        return leg.Traits.Linkage != LegLinkage.Pantograph ? ankle : ankle + Rotation.Rotate(Rotation.Multiply(shank, turns.Of(leg.Ankle, local.Ankle)), leg.Metatarsus);
    }
}
