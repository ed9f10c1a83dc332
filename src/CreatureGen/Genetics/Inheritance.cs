using CreatureGen.Blueprints;
using CreatureGen.Seeding;

namespace CreatureGen.Genetics;

/// <summary>From which parent each linked group of a child comes.</summary>
/// <param name="Frame">Kind, plan, limbs, posture, manner.</param>
/// <param name="Head">Skull, face, eyes, mouth, ears.</param>
/// <param name="Tail">Form of the tail and its end.</param>
/// <param name="Ornaments">Horns, spikes, hair, collars, shell, style of wings.</param>
/// <param name="Skin">Cover, colours, pattern.</param>
internal sealed record Inheritance(ParentName Frame, ParentName Head, ParentName Tail, ParentName Ornaments, ParentName Skin)
{
    /// <summary>Draws a child's groups: never all of one parent, and head and skin never both of the one that gives the frame. That alone makes children look like both.</summary>
    public static Inheritance Draw(RandomStream random)
    {
        ParentName Flip() => random.Chance(0.5) ? ParentName.First : ParentName.Second;
        var drawn = new Inheritance(Flip(), Flip(), Flip(), Flip(), Flip());
        if (drawn.Head != drawn.Frame || drawn.Skin != drawn.Frame)
        {
            return drawn;
        }

        ParentName other = drawn.Frame == ParentName.First ? ParentName.Second : ParentName.First;
        return random.Chance(0.5) ? drawn with { Head = other } : drawn with { Skin = other };
    }
}
