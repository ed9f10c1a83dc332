using CreatureGen.Maths;
using CreatureGen.Motion.Events;
using CreatureGen.Motion.Modes;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Falling;

/// <content>How it comes to its feet again.</content>
internal sealed partial class FallingMode
{
    /// <summary>How much quicker than by itself who is asked to go rises, and how quickly it comes to that, 1/τ.</summary>
    private const float Hurry = 1.35f;
    private const float HurryRate = 2f;

    private float haste = 1f;

    /// <summary>Goes on getting up. Who is asked to go hurries once it has gathered itself, and goes as soon as it stands.</summary>
    private void GoOnRising(in RootPlace place, float dt, in MotionInput input, in MotionSettings settings, IGround ground, BodyLayer? layer, in Pose local)
    {
        haste = Damping.Approach(haste, input.Goes && Up.Rises ? Hurry : 1f, HurryRate / Tau(place.Scale, settings.Gravity), dt);
        Up.Keep(local);
        bool over = Up.Advance(place, haste * dt, settings, ground, layer, local);
        if (over || (input.Goes && Up.Stands))
        {
            Recover();
            Up.Leave(dt, local);
            Tell(MotionEventKind.Rose, place, settings.Up, 0f, 0f);
        }
    }

    /// <summary>Is carried again, as if nothing had been.</summary>
    private void Recover()
    {
        State = BodyState.Supported;
        (footing, goesLimp, getsUp, haste) = (default, false, false, 1f);
        limp?.Stop();
        recoil?.Stop();
        reel?.Stop();
        up?.Stop();
        (blow, drift) = (Blow.None, default);
        if (legs != null)
        {
            legs.Sink = 0f;
            legs.Bow = 0f;
        }
    }
}
