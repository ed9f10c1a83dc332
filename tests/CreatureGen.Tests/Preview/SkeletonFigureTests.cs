using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Preview.Pictures;
using CreatureGen.Preview.Rendering;
using CreatureGen.Preview.Scenes;
using CreatureGen.Rigging;
using Xunit;

namespace CreatureGen.Tests.Preview;

public sealed class SkeletonFigureTests
{
    private const int Side = 400;

    [Theory]
    [MemberData(nameof(PreviewSubjects.SeedsAndViews), MemberType = typeof(PreviewSubjects))]
    public void The_figure_covers_its_joints(ulong seed, View view)
    {
        Skeleton skeleton = PreviewSubjects.Of(seed).Skeleton;
        RenderMesh figure = SkeletonFigure.From(skeleton);
        Camera camera = Camera.Fit(Views.Angle(view), figure.Positions, 1f);
        Picture picture = Renderer.Render(figure, camera, TestMeshes.Plain with { Width = Side, Height = Side, Samples = SampleCount.Eight });
        foreach (Joint joint in skeleton.Joints.Where(j => j.Parent >= 0 && j.Role != JointRole.End))
        {
            Vector3 place = camera.Project(joint.ModelPosition, Side, Side);
            Assert.True(picture[(int)place.X, (int)place.Y].A > 0, $"{joint.Name} is not covered");
        }
    }

    [Fact]
    public void The_figure_follows_a_pose()
    {
        Skeleton skeleton = PreviewSubjects.Of(1).Skeleton;
        var shift = new Vector3(5, 6, 7);
        RenderMesh rest = SkeletonFigure.From(skeleton);
        RenderMesh moved = SkeletonFigure.From(skeleton, skeleton.Joints.Select(j => j.ModelPosition + shift).ToArray());
        Assert.Equal(rest.Positions.Length, moved.Positions.Length);
        for (int i = 0; i < rest.Positions.Length; i++)
        {
            Assert.True(Vec.Distance(rest.Positions[i] + shift, moved.Positions[i]) < 1e-4f);
        }
    }

    [Fact]
    public void A_mirrored_pose_exchanges_nothing_but_places()
    {
        // Left is blue and right is red, wherever the joints are.
        Skeleton skeleton = PreviewSubjects.Of(2).Skeleton;
        RenderMesh rest = SkeletonFigure.From(skeleton);
        RenderMesh mirrored = SkeletonFigure.From(skeleton, skeleton.Joints.Select(j => Vec.Mirror(j.ModelPosition)).ToArray());
        Assert.Equal(rest.Colours.ToArray(), mirrored.Colours.ToArray());
        Assert.Contains(rest.Colours.ToArray(), c => c.Z > c.X * 3);
        Assert.Contains(rest.Colours.ToArray(), c => c.X > c.Z * 3);
    }

    [Fact]
    public void Joints_all_in_one_place_are_drawn_and_a_wrong_number_is_refused()
    {
        Skeleton skeleton = PreviewSubjects.Of(1).Skeleton;
        RenderMesh figure = SkeletonFigure.From(skeleton, new Vector3[skeleton.Count]);
        Assert.True(figure.Bounds.Diagonal < 1e-3f);
        Assert.Throws<ArgumentException>(() => SkeletonFigure.From(skeleton, new Vector3[skeleton.Count - 1]));
    }
}
