using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Beaks;
using CreatureGen.Appearance;
using CreatureGen.Appearance.Textures;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Features;
using CreatureGen.Limbs;
using CreatureGen.Maths;
using CreatureGen.Species;

namespace CreatureGen.Creatures;

/// <summary>What the coat has to know of a grown creature.</summary>
internal static class CoatSubjects
{
    /// <summary>Plates of a body that is no insect's where an insect has one: as broad as theirs they are parts of a machine, narrow ones the bands of an armadillo.</summary>
    private const float FinerPlates = 2f;

    /// <summary>The subject of a creature's coat.</summary>
    public static CoatSubject Of(CreatureBlueprint blueprint, GrownSurface grown, EyeFrame eye)
    {
        SpeciesProfile face = SpeciesCatalogue.Find(blueprint.Body.Blend.Face);
        var wings = new WingStyle[grown.Appendages.Count];
        for (int i = 0; i < blueprint.Wings.Count; i++)
        {
            wings[blueprint.Legs.Count + i] = blueprint.Wings[i].Style;
        }

        return new CoatSubject(grown.Skin.Shape)
        {
            Snout = face.Snout,
            Beak = blueprint.Head.Beak is BeakBlueprint beak ? BeakForm.Of(beak.Style) : null,
            Lips = blueprint.Head.Beak == null && grown.Mouth.Opens ? LipsOf(grown) : null,
            Mark = face.Class == AnimalClass.Arthropod ? HeadMark.None : HeadMarks.FromSeed(blueprint.Coat.PatternSeed),
            Gills = GillsOf(blueprint),
            Shell = blueprint.Body.Shell,
            Manes = blueprint.Manes,
            Tail = blueprint.Tail.Style,
            WingStyles = wings,
            EyeCentre = eye.Centre,
            EyeRadius = eye.Radius,
            EyeRing = (float)blueprint.Head.Eyes.Ring,
            EyeAround = (float)(blueprint.Head.Eyes.Segment * PortableMath.Tau / BodyGrid.Segments),
        };
    }

    /// <summary>Gills of fish that swim, by the body that gives most of the trunk.</summary>
    private static GillMark GillsOf(CreatureBlueprint blueprint)
    {
        SpeciesProfile trunk = SpeciesCatalogue.Find(blueprint.Body.Blend.First);
        bool fish = trunk.Class == AnimalClass.Fish && (blueprint.Plan == BodyPlan.Fish || (blueprint.Kind == LocomotionKind.Swimming && blueprint.Body.Disc.Sweep != 0));
        return !fish ? GillMark.None
            : blueprint.Body.Disc.Sweep != 0 ? GillMark.DiscSlits
            : trunk.Cover == SkinCover.Scales ? GillMark.Cover
            : GillMark.Slits;
    }

    private static MouthLine LipsOf(GrownSurface grown)
    {
        return new MouthLine(Left(grown.Mouth.UpperLip), Left(grown.Mouth.LowerLip), grown.Mouth.CornerRing, (float)grown.Skin.Shape.Width[StationRing.MuzzleMiddle]);

        Vector3[] Left(int[] lip) => Array.ConvertAll(lip.AsSpan(0, (lip.Length / 2) + 1).ToArray(), vertex => grown.Surface.Positions[vertex]);
    }

    /// <summary>The fine relief of a creature's skin.</summary>
    public static SkinRelief ReliefOf(CreatureBlueprint blueprint)
    {
        int salt = unchecked((blueprint.Coat.PatternSeed * 16) + 12);
        SpeciesProfile skin = SpeciesCatalogue.Find(blueprint.Body.Blend.Skin);
        bool smooth = blueprint.Plan == BodyPlan.Whale && skin.Class == AnimalClass.Fish && skin.Cover == SkinCover.Scales;
        return smooth ? new SkinRelief(SkinCover.Wrinkles, 0.05f, salt) : new SkinRelief(skin.Cover, skin.CoverSize, salt, IsOfInsects(blueprint.Plan) ? 1f : FinerPlates);
    }

    private static bool IsOfInsects(BodyPlan plan) => plan is BodyPlan.Hexapod or BodyPlan.Buzzing or BodyPlan.ManyLegged;
}
