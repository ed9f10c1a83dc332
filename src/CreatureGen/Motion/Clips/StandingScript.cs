using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Motion.Toolkit.Gaze;

namespace CreatureGen.Motion.Clips;

/// <summary>What head, lids and ears do in a recording of a creature that stands: as it does by itself, but so that it ends as it begins.</summary>
internal static class StandingScript
{
    /// <summary>Seconds into the recording at which the eyes blink.</summary>
    private const double BlinkAt = 1.4;

    /// <summary>Parts of the recording at which ears are flicked.</summary>
    private const double LeftEarAt = 0.22;
    private const double RightEarAt = 0.58;
    private const double LeftEarAgainAt = 0.64;

    /// <summary>Part of the recording in which the head turns.</summary>
    private const double Turning = 0.06;

    // When the head begins to turn, parts of the recording, and where to. The last part is for coming to rest.
    private static readonly (double At, LookAngles Look)[] glances =
    {
        (0, default),
        (0.10, new LookAngles(0.42f, 0.04f)),
        (0.36, new LookAngles(-0.34f, -0.08f)),
        (0.62, default),
    };

    /// <summary>Lids and ears.</summary>
    /// <param name="seconds">Into the recording.</param>
    /// <param name="whole">Its length, seconds.</param>
    public static StandingAct ActAt(double seconds, double whole) => new(
        Blinks.Once(seconds - BlinkAt),
        EarFlicks.Once(seconds - (LeftEarAt * whole)) + EarFlicks.Once(seconds - (LeftEarAgainAt * whole)),
        EarFlicks.Once(seconds - (RightEarAt * whole)));

    /// <summary>Where the head looks.</summary>
    /// <param name="fraction">Part of the recording, 0..1.</param>
    /// <param name="width">How wide its glances are, 1 for the usual.</param>
    public static LookAngles LookAt(double fraction, double width = 1)
    {
        LookAngles look = default;
        foreach ((double at, LookAngles next) in glances)
        {
            double t = Scalar.Smooth(Scalar.Clamp((fraction - at) / Turning, 0, 1));
            look = new LookAngles((float)Scalar.Lerp(look.Yaw, width * next.Yaw, t), (float)Scalar.Lerp(look.Pitch, width * next.Pitch, t));
        }

        return look;
    }
}
