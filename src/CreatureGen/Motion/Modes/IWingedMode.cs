using System.Numerics;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Modes;

/// <summary>A way of moving that has wings besides legs: it holds them where legs alone move the rest of the body, in a jump and in a fall, and takes over from them in the air.</summary>
internal interface IWingedMode : ILocomotionMode
{
    /// <summary>Moves its wings on and writes them over a pose.</summary>
    /// <param name="place">Where the creature is.</param>
    /// <param name="dt">Seconds.</param>
    /// <param name="open">Whether they are opened, or folded again.</param>
    /// <param name="settings">How it goes.</param>
    /// <param name="layer">What an act asks of wings; null for nothing.</param>
    /// <param name="local">Pose in the parents' space, as the legs wrote it; wings are written.</param>
    void HoldWings(in RootPlace place, float dt, bool open, in MotionSettings settings, BodyLayer? layer, in Pose local);

    /// <summary>Takes wing in the midst of the air: from the next update on it flies.</summary>
    /// <param name="velocity">Of the body, model space, metres of the model per second.</param>
    void TakeWing(Vector3 velocity);
}
