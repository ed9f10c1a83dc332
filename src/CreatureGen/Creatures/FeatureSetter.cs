using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Appearance;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Features;
using CreatureGen.Geometry;
using CreatureGen.Limbs;
using CreatureGen.Maths;
using CreatureGen.Rigging;
using CreatureGen.Species;

namespace CreatureGen.Creatures;

/// <summary>Sets eyes, claws, teeth, tongue, horns, hair and wings of insects on a grown surface. Everything at scale 1.</summary>
internal sealed class FeatureSetter
{
    private static readonly Vector3 toothColour = new(0.85f, 0.82f, 0.72f);
    private static readonly Vector3 combColour = new(0.46f, 0.022f, 0.026f);
    private static readonly Vector3 beadColour = new(0.012f, 0.011f, 0.012f);

    /// <summary>How much of the tip of a lure is white.</summary>
    private const float LureGlow = 0.6f;

    /// <summary>Wings broader than this, relative to their length, are covered with coloured scales (butterfly).</summary>
    private const double BroadWing = 0.4;

    /// <summary>Radii from which on an eye sits on a stalk.</summary>
    private const double StalkLength = 2;

    /// <summary>The ring of the trunk whose coat a further tail wears.</summary>
    private const float TailCoatRing = 47;

    /// <summary>Gums are behind lips and teeth.</summary>
    private const float GumSimplificationWeight = 0.3f;

    /// <summary>Hair is a mass of many locks, of which one more or less is not missed.</summary>
    private const float HairSimplificationWeight = 0.55f;

    private readonly CreatureBlueprint blueprint;
    private readonly GrownSurface grown;
    private readonly CoatPainter coat;
    private readonly CoatPalette palette;
    private readonly Vector3[] normals;
    private readonly List<Piece> pieces = new();
    private readonly List<Appendage> appendages;
    private readonly PieceBuilder builder = new();
    private readonly SpeciesProfile face;

    private FeatureSetter(CreatureBlueprint blueprint, GrownSurface grown, CoatPainter coat, Vector3[] normals)
    {
        this.blueprint = blueprint;
        this.grown = grown;
        this.coat = coat;
        palette = coat.Palette;
        this.normals = normals;
        face = SpeciesCatalogue.Find(blueprint.Body.Blend.Face);
        appendages = new List<Appendage>(grown.Appendages);
    }

    /// <summary>All pieces, and the appendages of the creature with those of antennae and insect wings behind them.</summary>
    public static (IReadOnlyList<Piece> Pieces, IReadOnlyList<Appendage> Appendages) Set(CreatureBlueprint blueprint, GrownSurface grown, CoatPainter coat, Vector3[] normals)
    {
        var setter = new FeatureSetter(blueprint, grown, coat, normals);
        EyeSetter.Add(blueprint, grown, coat, setter.builder, setter.pieces);
        BeakSetter? beak = blueprint.Head.Beak != null && grown.Mouth.Opens ? new BeakSetter(blueprint.Head.Beak, blueprint.Head.Mouth, grown) : null;
        setter.AddBeak(beak);
        setter.AddNostrils(beak);
        setter.AddTongue();
        setter.AddTeeth();
        setter.AddClaws();
        setter.AddWebs();
        foreach (FeatureBlueprint feature in blueprint.Features)
        {
            setter.AddFeature(feature);
        }

        foreach (FrillBlueprint frill in blueprint.Frills)
        {
            setter.AddFrill(frill);
        }

        foreach (InsectWingBlueprint wing in blueprint.InsectWings)
        {
            setter.AddInsectWing(wing);
        }

        setter.AddManes();

        return (setter.pieces, setter.appendages);
    }

    private void AddBeak(BeakSetter? beak)
    {
        if (beak == null)
        {
            return;
        }

        builder.Clear(SurfaceFinish.Horn);
        beak.AppendUpper(builder, palette, coat.BeakColour);
        AddRigid("Head");
        builder.Clear(SurfaceFinish.Horn);
        beak.AppendLower(builder, coat.BeakColour);
        AddRigid("Jaw");
    }

    private void AddNostrils(BeakSetter? beak)
    {
        if (blueprint.Head.NostrilSize == 0)
        {
            return;
        }

        NoseBed? leather = NostrilSetter.BedOf(blueprint, grown);
        if (leather is NoseBed bed)
        {
            builder.Clear(SurfaceFinish.Horn);
            NostrilSetter.AppendLeather(builder, bed, palette);
            AddRigid("Head");
        }

        builder.Clear();
        NostrilSetter.Append(builder, blueprint, grown, coat, beak, leather);
        AddRigid("Head");
    }

    private void AddTongue()
    {
        if (blueprint.Head.Mouth.Tongue == TongueStyle.None || !grown.Mouth.Opens)
        {
            return;
        }

        builder.Clear(SurfaceFinish.Tooth);
        MouthSetter.AppendTongue(builder, blueprint, grown, palette.Tongue);
        AddRigid("Jaw");
    }

    private void AddTeeth()
    {
        if (blueprint.Head.Mouth.Teeth == 0 || !grown.Mouth.Opens)
        {
            return;
        }

        var teeth = new ToothSetter(blueprint, grown, normals, face.Dentition);
        Add(Jaw.Upper, "Head");
        Add(Jaw.Lower, "Jaw");

        void Add(Jaw jaw, string joint)
        {
            builder.Clear();
            teeth.AppendGum(builder, jaw);
            AddRigid(joint, GumSimplificationWeight);
            builder.Clear(SurfaceFinish.Tooth);
            teeth.AppendTeeth(builder, jaw, toothColour);
            AddRigid(joint);
        }
    }

    private void AddClaws()
    {
        foreach (DigitTip tip in grown.Tips)
        {
            float floor = tip.Position.Y < 3f * tip.Radius ? 0f : float.NegativeInfinity;
            builder.Clear(SurfaceFinish.Horn);
            if (tip.Kind == DigitTipKind.Hallux)
            {
                HalluxShape.Append(builder, tip.Position, tip.Direction, tip.Radius, tip.Radius * tip.ClawLength, palette.Limb, palette.Claw);
            }
            else if (tip.Kind == DigitTipKind.Nail)
            {
                NailShape.Append(builder, tip.Position, tip.Direction, tip.Radius, floor, palette.Claw);
            }
            else if (tip.ClawLength > 0f)
            {
                ClawShape.Append(builder, tip.Position, tip.Direction, tip.Radius, tip.Radius * tip.ClawLength * 1.6f, floor, palette.Claw);
            }
            else
            {
                continue;
            }

            AddOnSurface(tip.Vertex);
        }
    }

    private void AddWebs()
    {
        foreach (ToeWeb web in grown.Webs)
        {
            builder.Clear();
            WebShape.Append(builder, web.Root, web.First, web.Second, web.Thickness, web.Floor, Vec.Lerp(palette.Limb, palette.Accent, 0.3f));
            AddOnSurface(web.Vertex);
        }
    }

    /// <summary>An eye that looks as the two that move do, on a stalk where it is long.</summary>
    private void AddEye(FeatureBlueprint feature, in FeatureCurve curve)
    {
        EyeBlueprint eyes = blueprint.Head.Eyes;
        float radius = (float)feature.Radius;
        bool stalked = feature.Length > StalkLength * feature.Radius;
        bool median = feature.Segment is 0 or BodyGrid.Segments / 2;
        SurfacePoint skin = curve.Skin;
        Vector3 forward = grown.Skin.Shape.Forward((int)feature.Ring);
        Vector3 look = median ? new Vector3(0f, skin.Normal.Y, skin.Normal.Z) : skin.Normal;
        Vector3 gaze = Vec.Normalize((stalked ? Vector3.UnitX * (median ? 0f : 0.7f) : look * 0.75f) + (forward * (float)eyes.Forward), forward);
        Vector3 centre = stalked ? curve.Point(1f) : skin.Position - (look * (radius * (float)eyes.Sink));
        if (stalked)
        {
            StalkShape.Append(builder, curve, 0.5f * radius, palette.Base, palette.Limb);
        }

        EyeShape.Append(builder, new EyeFrame(centre, radius, gaze), eyes.Style, palette.Iris, palette.Base * 0.5f);
    }

    private void AddTail(FeatureBlueprint feature, in FeatureCurve curve)
    {
        builder.Clear();
        var address = new VertexAddress { Region = SurfaceRegion.Body, Appendage = -1, Sign = 1, Ring = TailCoatRing, Segment = (float)feature.Segment };
        Vector3[] joints = TailShape.Append(builder, feature, curve, (position, normal) => coat.At(address, position, normal));
        AddChain(LimbKind.Tail, feature.Ring, joints, MaterialKind.Skin);
    }

    private void AddFeature(FeatureBlueprint feature)
    {
        BodyShape shape = grown.Skin.Shape;
        int ring = (int)feature.Ring;
        bool median = feature.Segment is 0 or 16;
        var curve = new FeatureCurve(feature, grown.Skin.At(feature.Ring, feature.Segment), shape.Forward(ring), Vector3.UnitY, 1f);
        builder.Clear(feature.Kind == FeatureKind.Ocellus ? SurfaceFinish.Eye : SurfaceFinish.Horn);
        if (feature.Kind == FeatureKind.Antenna)
        {
            AntennaShape.Append(builder, feature, curve, 1f, palette.Limb * 0.8f, feature.Flatness < 0.5 ? palette.Limb * 0.8f : palette.Accent);
            AddChain(LimbKind.Antenna, feature.Ring, curve.JointPoints(), MaterialKind.Skin);
            return;
        }

        if (feature.Kind == FeatureKind.Tail)
        {
            AddTail(feature, curve);
            return;
        }

        if (feature.Kind == FeatureKind.Eye)
        {
            AddEye(feature, curve);
        }
        else if (feature.Kind == FeatureKind.Lure)
        {
            LureShape.Append(builder, feature, curve, palette.Back, palette.Accent, Vec.Lerp(palette.Accent, Vector3.One, LureGlow));
        }
        else if (feature.Kind == FeatureKind.Comb)
        {
            builder.Clear();
            CombShape.Append(builder, feature, grown.Skin, combColour);
        }
        else if (feature.Kind == FeatureKind.Antler)
        {
            AntlerShape.Append(builder, feature, curve, 1f, palette.Horn);
        }
        else
        {
            HornShape.Append(builder, feature, curve, 1f, ColourOf(feature.Kind));
        }

        int vertex = grown.BodyVertex(ring, (int)Math.Round(feature.Segment));
        if (median)
        {
            pieces.Add(builder.ToPiece(MaterialKind.Skin, new PieceBinding.SurfaceVertex(vertex)));
        }
        else
        {
            AddOnSurface(vertex);
        }
    }

    private Vector3 ColourOf(FeatureKind horn) => horn switch
    {
        FeatureKind.Horn or FeatureKind.Spike or FeatureKind.Club => palette.Horn,
        FeatureKind.Tuft => palette.Accent,
        FeatureKind.Mandible => palette.Claw,
        FeatureKind.Tusk => toothColour,
        FeatureKind.Scute => palette.Back * 0.9f,
        FeatureKind.Ocellus => beadColour,
        FeatureKind.Plate => Vec.Lerp(palette.Accent, palette.Back, 0.35f) * 0.85f,
        _ => throw new ArgumentOutOfRangeException(nameof(horn), horn, "expected a kind that is built as horns are"),
    };

    /// <summary>Hair comes last, for it takes the triangles that the budget leaves: to cut them out of a finished creature takes several times as long as to grow it.</summary>
    private void AddManes()
    {
        int room = blueprint.TriangleBudget - (grown.Surface.Triangles.Length / 3);
        foreach (Piece piece in pieces)
        {
            room -= piece.Triangles.Length / 3;
        }

        int coarseness = ManeShape.CoarsenessWithin(room, blueprint.Manes);
        foreach (ManeBlueprint mane in blueprint.Manes)
        {
            builder.Clear(SurfaceFinish.Hair);
            var addresses = new List<SkinAddress>();
            ManeShape.Append(builder, mane, coarseness, grown.Skin, HairCoat.ColourOf(palette, blueprint.Manes), addresses);
            int[] vertices = addresses.ConvertAll(address => grown.BodyVertex(address.Ring, address.Segment)).ToArray();
            pieces.Add(builder.ToPiece(MaterialKind.Skin, new PieceBinding.Skin(vertices), HairSimplificationWeight));
        }
    }

    private void AddFrill(FrillBlueprint frill)
    {
        builder.Clear();

        // A thick collar is bone under the skin of the head; a thin one is a fan that is there to be seen.
        float bony = Scalar.Clamp((float)(10 * frill.Thickness / frill.Length), 0f, 1f);
        FrillShape.Append(builder, frill, grown.Skin, Vec.Lerp(palette.Accent, palette.Base, 0.45f * bony), palette.Base, palette.Back * 0.6f);
        AddRigid("Head");
    }

    private void AddInsectWing(InsectWingBlueprint wing)
    {
        SurfacePoint skin = grown.Skin.At(wing.Ring, wing.Segment);
        builder.Clear(SurfaceFinish.Wing);
        bool scaled = wing.Width > BroadWing * wing.Length;
        InsectWingShape.Append(builder, skin, wing, 1f, scaled ? palette.Accent : Vec.Lerp(palette.Accent, Vector3.One, 0.55f), palette.Base * 0.4f);
        AddChain(LimbKind.InsectWing, wing.Ring, InsectWingShape.JointPoints(skin, wing, 1f), MaterialKind.Membrane);
    }

    /// <summary>Adds what the builder holds, left and right, as one piece on a joint of the midline.</summary>
    private void AddRigid(string joint, float simplificationWeight = 1f) => pieces.Add(builder.ToPiece(MaterialKind.Skin, new PieceBinding.Joint(joint), simplificationWeight));

    /// <summary>Adds what the builder holds on a vertex of the left side, and its mirror image.</summary>
    private void AddOnSurface(int vertex)
    {
        Piece left = builder.ToPiece(MaterialKind.Skin, new PieceBinding.SurfaceVertex(vertex));
        pieces.Add(left);
        pieces.Add(PieceMirror.Mirror(left, new PieceBinding.SurfaceVertex(grown.Surface.Mirror[vertex])));
    }

    /// <summary>Adds what the builder holds as an appendage with joints of its own, and its mirror image.</summary>
    private void AddChain(LimbKind kind, double ring, Vector3[] joints, MaterialKind material)
    {
        int pair = 1;
        foreach (Appendage other in appendages)
        {
            pair += other.Kind == kind ? 1 : 0;
        }

        Piece left = builder.ToPiece(material, new PieceBinding.Chain(appendages.Count, Side.Left));
        pieces.Add(left);
        pieces.Add(PieceMirror.Mirror(left, new PieceBinding.Chain(appendages.Count, Side.Right)));
        appendages.Add(new Appendage
        {
            Kind = kind,
            Pair = pair,
            Paired = true,
            RootRing = ring,
            Joints = joints,
            JointsAlong = Array.ConvertAll(joints, joint => Array.IndexOf(joints, joint) / (joints.Length - 1f)),
            Pole = Vec.Normalize(Vec.Reject(Vector3.UnitY, Vec.Normalize(joints[joints.Length - 1] - joints[0])), Vector3.UnitZ),
            Contact = joints[joints.Length - 1],
        });
    }
}
