using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Features;
using CreatureGen.Geometry;
using CreatureGen.Rigging;
using CreatureGen.Skinning;

namespace CreatureGen.Creatures;

/// <summary>Skin, rig and pieces of a creature before they become its mesh.</summary>
internal sealed record Body(Surface Surface, Vector3[] Normals, Vector3[] Colours, SkinWeights[] Weights, IReadOnlyList<Piece> Pieces, Rig Rig);
