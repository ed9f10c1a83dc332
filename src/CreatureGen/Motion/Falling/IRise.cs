using CreatureGen.Motion.Modes;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Falling;

/// <summary>How a creature rises onto its feet, which stand or are about to, by the walk's own leg solver.</summary>
internal interface IRise
{
    /// <summary>Poses it as it is when it begins to rise, its feet where they belong.</summary>
    /// <param name="place">Where it will stand.</param>
    /// <param name="settings">Up and gravity.</param>
    /// <param name="ground">What it lies on.</param>
    /// <param name="layer">What an act or a mood asks of trunk and feet.</param>
    /// <param name="height">How high the middle of its trunk is to be at the least, metres of the model, as far as it is before it stands: lower it would only come down to rise again.</param>
    /// <param name="local">The pose in which it stands; receives that in which it begins.</param>
    void Begin(in RootPlace place, in MotionSettings settings, IGround ground, BodyLayer? layer, float height, in Pose local);

    /// <summary>Seconds that it takes.</summary>
    /// <param name="tau">√(leg length / gravity).</param>
    float Seconds(float tau);

    /// <summary>Poses it on its way.</summary>
    /// <param name="u">Part of the time that has gone by, 0..1.</param>
    /// <param name="place">Where it will stand.</param>
    /// <param name="dt">Seconds since the last.</param>
    /// <param name="settings">Up and gravity.</param>
    /// <param name="layer">What an act or a mood asks of trunk and feet.</param>
    /// <param name="local">The pose at rest; receives the pose.</param>
    void Show(float u, in RootPlace place, float dt, in MotionSettings settings, BodyLayer? layer, in Pose local);

    /// <summary>Goes on from where another of the same creature is.</summary>
    void CopyFrom(IRise other);
}
