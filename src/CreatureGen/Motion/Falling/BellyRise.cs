using System;
using CreatureGen.Maths;
using CreatureGen.Motion.Acts.Bodies;
using CreatureGen.Motion.Acts.Playing;
using CreatureGen.Motion.Modes;
using CreatureGen.Motion.Walking;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Falling;

/// <summary>Rises from the belly, its legs folded under it, by the last phases of the act of lying down: feet come to where they stand as the trunk is raised over them, hind first or fore first, without a rest between the phases.</summary>
internal sealed class BellyRise : IRise
{
    /// <summary>Part of the time of the act in which who fell gets up: it was not lying at ease.</summary>
    private const float Haste = 0.65f;

    /// <summary>Parts of the rise in which the place is sought at which its trunk is so high, and how many of them may be left out.</summary>
    private const int Parts = 20;
    private const int MaxLeftOut = 13;

    private readonly FallProfile profile;
    private readonly LyingManner manner;
    private readonly WalkingMode legs;
    private readonly Performer performer;
    private readonly BodyLayer asked;
    private readonly PoseBuffer shown;
    private readonly float[] values = new float[Act.ChannelCount];
    private readonly ActFlow flow;
    private float lift;
    private float start;

    public BellyRise(FallProfile profile, LyingManner manner, WalkingMode legs)
    {
        this.profile = profile;
        this.manner = manner;
        this.legs = legs;
        performer = new Performer(manner.Body, manner.Room);
        asked = new BodyLayer(legs.FootCount);
        shown = new PoseBuffer(profile.Skeleton);
        ReadOnlySpan<ActPhase> phases = manner.Act.AllPhases;
        int first = 1;
        while (!phases[first - 1].Lasts)
        {
            first++;
        }

        // Times of an act are those of a leg length and a gravity of one, to begin with.
        flow = new ActFlow(manner.Act, first, manner.Gain);
    }

    /// <inheritdoc/>
    public void Begin(in RootPlace place, in MotionSettings settings, IGround ground, BodyLayer? layer, float height, in Pose local)
    {
        performer.Forget();
        lift = 0f;
        for (int part = 0; part <= MaxLeftOut; part++)
        {
            start = (float)part / Parts;
            Show(0f, place, 0f, settings, layer, local);
            shown.Take(local);
            shown.Finish();
            if (profile.TrunkHeight(shown.Model) >= height)
            {
                break;
            }
        }

        lift = -profile.Support.Lowest(BodyPart.Trunk | BodyPart.Limb, place, shown.Model, settings.Up, ground, out _);
        profile.Raise(local, lift);
    }

    /// <inheritdoc/>
    public float Seconds(float tau) => Haste * (1f - start) * flow.Duration * tau * manner.Tempo;

    /// <inheritdoc/>
    public void Show(float u, in RootPlace place, float dt, in MotionSettings settings, BodyLayer? layer, in Pose local)
    {
        flow.Write(start + ((1f - start) * u), values);
        ActGround under = ActGround.Under(legs.Feet, place);
        performer.Show(values, default, place);
        performer.LayFeetAlong(under);
        asked.CopyFrom(performer.Trunk!);
        asked.Still = 0f;
        asked.Add(layer);
        legs.Hold(place, dt, settings, asked, local);
        shown.Take(local);
        performer.Pose(place, true, under, shown.Local, shown.Model);
        shown.Local.Rotations.CopyTo(local.Rotations);
        shown.Local.Positions.CopyTo(local.Positions);
        profile.Raise(local, lift * (1f - Scalar.Smooth(u)));
    }

    /// <inheritdoc/>
    public void CopyFrom(IRise other)
    {
        var rise = (BellyRise)other;
        performer.CopyFrom(rise.performer);
        (lift, start) = (rise.lift, rise.start);
    }
}
