using CreatureGen.Blueprints;
using CreatureGen.Sampling.Shapes;

namespace CreatureGen.Sampling;

/// <summary>What the sampler itself can see of the library's promises: a creature that breaks one is drawn again, with fewer parts of other parents.</summary>
internal static class Soundness
{
    /// <summary>Whether a creature stands, has a socket for every limb, and is a good blueprint.</summary>
    public static bool Holds(CreatureBlueprint blueprint, CreatureBuilder builder, SocketTally sockets) =>
        sockets.LimbRefusals == 0 && builder.IsCarried && !StanceSampler.Sinks(builder) && !StanceSampler.TipsOver(builder) && BlueprintValidator.Validate(blueprint).Count == 0;
}
