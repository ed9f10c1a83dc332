using CreatureGen.Anatomy;
using CreatureGen.Appearance;
using CreatureGen.Appearance.Textures;
using CreatureGen.Blueprints;
using CreatureGen.Features;
using CreatureGen.Limbs;
using CreatureGen.Species;

namespace CreatureGen.Creatures;

/// <summary>What the coat has to know of a grown creature.</summary>
internal static class CoatSubjects
{
    /// <summary>The subject of a creature's coat.</summary>
    public static CoatSubject Of(CreatureBlueprint blueprint, GrownSurface grown, EyeFrame eye)
    {
        string family = SpeciesCatalogue.Find(blueprint.Body.Blend.First).Family;
        var wings = new WingStyle[grown.Appendages.Count];
        for (int i = 0; i < blueprint.Wings.Count; i++)
        {
            wings[blueprint.Legs.Count + i] = blueprint.Wings[i].Style;
        }

        return new CoatSubject(grown.Skin.Shape)
        {
            Snout = SnoutOf(family),
            Mark = family == "insect" ? HeadMark.None : HeadMarks.FromSeed(blueprint.Coat.PatternSeed),
            Shell = blueprint.Body.Shell,
            Manes = blueprint.Manes,
            Tail = blueprint.Tail.Style,
            WingStyles = wings,
            EyeCentre = eye.Centre,
            EyeRadius = eye.Radius,
        };
    }

    /// <summary>The fine relief of a creature's skin.</summary>
    public static SkinRelief ReliefOf(CreatureBlueprint blueprint)
    {
        string body = blueprint.Body.Blend.First;
        (SkinCover cover, float size) = body switch
        {
            "bee" or "moth" => (SkinCover.Fur, 0.022f),
            "shark" or "ray" or "dolphin" or "puffer" => (SkinCover.Wrinkles, 0.022f),
            "angler" or "pterosaur" or "rhino" => (SkinCover.Wrinkles, 0.05f),
            _ => CoverOf(SpeciesCatalogue.Find(body).Family, blueprint.Plan),
        };
        return new SkinRelief(cover, size, unchecked((blueprint.Coat.PatternSeed * 16) + 12));
    }

    /// <summary>What the skin of a family is covered with, and the size of one hair, feather, scale or plate.</summary>
    private static (SkinCover Cover, float Size) CoverOf(string family, BodyPlan plan) => family switch
    {
        "canine" or "feline" => (SkinCover.Fur, 0.022f),
        "bovine" => (SkinCover.Fur, 0.016f),
        "avian" => (SkinCover.Feathers, 0.04f),
        "reptile" => (SkinCover.Scales, 0.04f),
        "serpent" => (SkinCover.Scales, 0.034f),
        "fish" => plan == BodyPlan.Whale ? (SkinCover.Wrinkles, 0.05f) : (SkinCover.Scales, 0.045f),
        "insect" => (SkinCover.Plates, 0.09f),
        _ => (SkinCover.Wrinkles, 0.05f),
    };

    private static SnoutCoat SnoutOf(string body) => body switch
    {
        "canine" or "feline" or "bovine" => SnoutCoat.Leather,
        "avian" => SnoutCoat.Beak,
        _ => SnoutCoat.Bare,
    };
}
