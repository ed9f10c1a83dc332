using CreatureGen.Motion.Toolkit;
using CreatureGen.Motion.Toolkit.Springs;

namespace CreatureGen.Motion;

/// <summary>A chain of a creature that swings by itself: all of a kind share what is known of it.</summary>
internal sealed class SwingingChain
{
    /// <summary>How it swings. A field: what is asked of it is not to be asked of a copy.</summary>
    public readonly SpringSettings Settings;

    public SwingingChain(SpringRig rig, in SpringSettings settings)
    {
        Rig = rig;
        Settings = settings;
        Tuning = new SpringTuning(rig, settings);
    }

    /// <summary>Its joints.</summary>
    public SpringRig Rig { get; }

    /// <summary>What the settings come to.</summary>
    public SpringTuning Tuning { get; }
}
