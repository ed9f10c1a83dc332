using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Modes;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Falling;

/// <content>Where the root is of who lies and gets up.</content>
internal sealed partial class FallingMode
{
    /// <summary>Seconds in which the root comes to be under a body that falls, and to where one stands that gets up, τ = √(ℓ/g).</summary>
    private const float GlideTime = 4f;

    private RootGlide glide;

    /// <inheritdoc/>
    public RootPlace Update(RootPlace place, float dt, in MotionInput input, in MotionSettings settings, IGround ground, BodyLayer? layer, in Pose local)
    {
        RootPlace from = glide.Goal(place);
        See(place, from, local);
        RootPlace to = Advance(from, dt, input, settings, ground, layer, local);
        glide.Advance(dt);
        RootPlace shown = glide.Shown(to);
        See(to, shown, local);
        return shown;
    }

    /// <summary>Writes a pose as seen from another root.</summary>
    private void See(in RootPlace before, in RootPlace after, in Pose local)
    {
        if (!glide.IsOver)
        {
            RootFrame.Change(subject.Skeleton, profile.Value.Body, before, after, local);
        }
    }

    /// <summary>Falls on limp, or lies.</summary>
    private RootPlace Lie(in RootPlace place, float dt, in MotionSettings settings, IGround ground, in Pose local)
    {
        bool begins = !Lying.Falls;
        RootPlace under = Lying.Advance(place, dt, settings, ground);
        Lying.Show(under, dt, settings, ground, local);
        return begins ? GlideTo(under, place, settings) : under;
    }

    /// <summary>Begins to get up from where it lies.</summary>
    private RootPlace Rise(in RootPlace place, in MotionSettings settings, IGround ground, BodyLayer? layer)
    {
        RootPlace stand = GlideTo(Lying.PlaceUnder(place, settings, ground), place, settings);
        Up.Begin(Lying, stand, settings, ground, layer);
        Lying.Stop();
        getsUp = false;
        State = BodyState.Rising;
        Tell(MotionEventKind.Rises, stand, settings.Up, 0f, 0f);
        return stand;
    }

    /// <summary>The root is to be elsewhere from now on.</summary>
    private RootPlace GlideTo(in RootPlace goal, in RootPlace place, in MotionSettings settings)
    {
        glide.Begin(glide.Shown(place), goal, GlideTime * Tau(place.Scale, settings.Gravity));
        return goal;
    }
}
