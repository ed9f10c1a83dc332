using CreatureGen.Sampling;
using CreatureGen.Seeding;

namespace CreatureGen.Tests.Sampling;

/// <summary>Sizes for tests that are not about size: each seed has one, anywhere in the range that is asked for, whatever the animal. What holds for a body holds at any size that a game may ask for.</summary>
internal static class SizeOfSeed
{
    /// <summary>The same options, and only one size.</summary>
    public static CreatureOptions In(CreatureOptions options, ulong seed)
    {
        double size = new Seed(seed).Child("scale").Stream().Uniform(options.MinScale, options.MaxScale);
        return options with { MinScale = size, MaxScale = size };
    }
}
