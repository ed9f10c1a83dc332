using System;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Preview.Scenes;
using Xunit;

namespace CreatureGen.Tests.Preview;

public sealed class RenderMeshTests
{
    private static readonly SurfaceMaterial skin = SurfaceMaterial.Skin;

    [Fact]
    public void Bad_arrays_are_refused()
    {
        Assert.Throws<ArgumentException>(() => Make(normals: 2));
        Assert.Throws<ArgumentException>(() => Make(colours: 4));
        Assert.Throws<ArgumentException>(() => Make(gloss: 1));
        Assert.Throws<ArgumentException>(() => Make(texcoords: 1));
        Assert.Throws<ArgumentException>(() => Make(index: 3));
        Assert.Throws<ArgumentException>(() => Make(index: -1));
        Assert.Throws<ArgumentException>(() => Make(height: float.NaN));
        Assert.Throws<ArgumentException>(() => Make(height: float.PositiveInfinity));
        Assert.Throws<ArgumentException>(() => Make(firstGloss: float.NaN));
        Assert.Throws<ArgumentException>(() => Make(firstPlace: float.NaN));
        Assert.Throws<ArgumentException>(() => Make(new RenderPart(skin, 0, 2)));
        Assert.Throws<ArgumentException>(() => Make(new RenderPart(skin, 0, 0)));
        Assert.Throws<ArgumentException>(() => Make(new RenderPart(skin, 0, 6)));
        Assert.Throws<ArgumentException>(() => Make(new RenderPart(skin, 3, 3)));
        Assert.Equal(3, Make().Triangles.Length);
    }

    [Fact]
    public void A_creature_keeps_its_arrays_and_has_wet_eyes()
    {
        Creature creature = PreviewSubjects.Of(2);
        RenderMesh mesh = RenderMesh.From(creature);
        Assert.Equal(creature.Mesh.Positions.Length, mesh.Positions.Length);
        Assert.Equal(creature.Mesh.Triangles.Length, mesh.Triangles.Length);
        Assert.Contains(1f, mesh.Gloss.ToArray());
        Assert.Contains(0f, mesh.Gloss.ToArray());
        Assert.Throws<ArgumentException>(() => RenderMesh.From(creature, new Vector3[3], new Vector3[3]));
    }

    private static RenderMesh Make(RenderPart? part = null, int normals = 3, int colours = 3, int gloss = 3, int texcoords = 3, int index = 2, float height = 0f, float firstGloss = 0f, float firstPlace = 0f)
    {
        var shine = new float[gloss];
        shine[0] = firstGloss;
        var places = new Vector2[texcoords];
        places[0].Y = firstPlace;
        return new RenderMesh([Vector3.Zero, Vector3.UnitX, new Vector3(0, height, 0)], new Vector3[normals], new Vector3[colours], [0, 1, index], [part ?? new RenderPart(skin, 0, 3)], shine, places);
    }
}
