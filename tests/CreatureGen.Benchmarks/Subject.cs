using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Appearance;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Creatures;
using CreatureGen.Features;
using CreatureGen.Geometry;
using CreatureGen.Limbs;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using CreatureGen.Skinning;
using CreatureGen.Species;

namespace CreatureGen.Benchmarks;

/// <summary>One creature, and what each stage of its assembly starts from.</summary>
internal sealed class Subject
{
    public Subject(ulong seed, LocomotionKind kind)
    {
        Seed = seed;
        Blueprint = BlueprintSampler.Sample(seed, kind);
        Shape = BodyShaper.Shape(Blueprint.Plan, Blueprint.Body, Blueprint.Head, Blueprint.Tail);
        Grown = GrownSurface.Grow(Blueprint);
        Normals = new Vector3[Grown.Surface.Positions.Length];
        SurfaceNormals.Smooth(Grown.Surface.Positions, Grown.Surface.Triangles, Normals);
        EyeFrame eye = EyeSetter.EyeOf(Blueprint, Grown);
        Painter = new CoatPainter(Blueprint.Coat, CoatSubjects.Of(Blueprint, Grown, eye));
        (Pieces, IReadOnlyList<Appendage> appendages) = FeatureSetter.Set(Blueprint, Grown, Painter, Normals);
        RigInput = new RigInput(Blueprint, Grown.Skin, Grown.Surface, Grown.Adjacency, appendages, Grown.Mouth, EyeSetter.SocketOf(Blueprint, eye));
        Rig = CreatureRigger.Build(RigInput);
        Weights = AnatomicalWeights.Solve(RigInput, Rig);
        Creature = CreatureAssembler.Assemble(Blueprint);
    }

    public ulong Seed { get; }

    public CreatureBlueprint Blueprint { get; }

    public BodyShape Shape { get; }

    public GrownSurface Grown { get; }

    public Vector3[] Normals { get; }

    public CoatPainter Painter { get; }

    public IReadOnlyList<Piece> Pieces { get; }

    public RigInput RigInput { get; }

    public Rig Rig { get; }

    public SkinWeights[] Weights { get; }

    public Creature Creature { get; }
}
