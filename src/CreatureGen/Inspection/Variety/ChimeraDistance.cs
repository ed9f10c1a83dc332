using CreatureGen.Blueprints;
using CreatureGen.Species;

namespace CreatureGen.Inspection.Variety;

/// <summary>How far the parts of a creature are from those of the animal that leads in its torso.</summary>
internal static class ChimeraDistance
{
    /// <summary>From here on nobody names a creature after that animal.</summary>
    public const double Nameless = 1;

    private const double OtherClassOfHead = 1;
    private const double OtherHead = 0.5;
    private const double OtherClassOfSkin = 0.4;
    private const double OtherTail = 0.4;
    private const double OtherManner = 0.4;

    /// <summary>Share that the leading animal must keep in a region for the region to be its own.</summary>
    private const double OwnFraction = 0.4;

    /// <summary>0 for an animal, 1 and more for what has no name.</summary>
    public static double Of(CreatureBlueprint blueprint)
    {
        BodyBlend blend = blueprint.Body.Blend;
        AnimalClass body = ClassOf(blend.First);
        double head = ClassOf(blend.Face) != body ? OtherClassOfHead : blend.Face != blend.First ? OtherHead : 0;
        double skin = ClassOf(blend.Skin) != body ? OtherClassOfSkin : 0;
        double tail = blend.TailFractions[0] < OwnFraction ? OtherTail : 0;
        double manner = blend.Manner != blend.First ? OtherManner : 0;
        return head + skin + tail + manner;
    }

    private static AnimalClass ClassOf(string body) => SpeciesCatalogue.Find(body).Class;
}
