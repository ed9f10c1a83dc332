using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Creatures;
using CreatureGen.Preview.Pictures;
using CreatureGen.Preview.Scenes;
using CreatureGen.Rigging;

namespace CreatureGen.Preview.Rendering;

/// <summary>Pictures of whole creatures in one call.</summary>
public static class Portrait
{
    // Opacity of the creature around its bones.
    private const float GhostOpacity = 0.42f;

    // Room around the head, part of the radius of the ball around it.
    private const float FaceRoom = 0.86f;

    /// <summary>Radius of what a picture of a face shows about the eyes, relative to how far the snout is ahead of them.</summary>
    private const float AboutTheEyes = 1.2f;

    /// <summary>The creature on its way from a named side, as large as the frame allows: in mid-step, in mid-stroke, at the top of its wings' beat, in the bends of its crawl. What flies has its wings spread as they were built where the view is from ahead, behind or above: there beating wings are seen along their blades.</summary>
    public static Picture Take(Creature creature, View view, RenderOptions options)
    {
        ArgumentNullException.ThrowIfNull(options);
        RenderMesh mesh = OnItsWay(creature, view);
        return Dressed(creature, mesh, Fit(creature, mesh, view, options), options);
    }

    /// <summary>The same under the atlas of its file, or in the colours of its vertices.</summary>
    /// <param name="creature">The creature.</param>
    /// <param name="textures">Its atlas; null for none.</param>
    /// <param name="view">From which side.</param>
    /// <param name="options">How. Faces of one colour take none of the atlas.</param>
    public static Picture Take(Creature creature, CreatureTextures? textures, View view, RenderOptions options)
    {
        ArgumentNullException.ThrowIfNull(options);
        RenderMesh mesh = OnItsWay(creature, view);
        Camera camera = Fit(creature, mesh, view, options);
        return Renderer.Render(textures is not null && TakesTextures(options) ? mesh.WithTextures(textures) : mesh, camera, options);
    }

    /// <summary>The creature as it was built, from a named side, as large as the frame allows.</summary>
    public static Picture TakeAtRest(Creature creature, View view, RenderOptions options)
    {
        ArgumentNullException.ThrowIfNull(creature);
        ArgumentNullException.ThrowIfNull(options);
        RenderMesh mesh = RenderMesh.From(creature);
        return Dressed(creature, mesh, Fit(creature, mesh, view, options), options);
    }

    /// <summary>The creature in rest pose, half transparent, and its bones and joints.</summary>
    public static Picture TakeSkeleton(Creature creature, View view, RenderOptions options)
    {
        ArgumentNullException.ThrowIfNull(creature);
        ArgumentNullException.ThrowIfNull(options);
        RenderMesh mesh = RenderMesh.From(creature);
        return WithSkeleton(mesh, SkeletonFigure.From(creature.Skeleton), Fit(creature, mesh, view, options), options);
    }

    /// <summary>A half transparent surface with the figure of a skeleton drawn over it.</summary>
    /// <param name="mesh">The creature's surface.</param>
    /// <param name="figure">Its skeleton in the same pose, from <see cref="SkeletonFigure"/>.</param>
    /// <param name="camera">From where.</param>
    /// <param name="options">How; its opacity is reduced.</param>
    public static Picture WithSkeleton(RenderMesh mesh, RenderMesh figure, Camera camera, RenderOptions options)
    {
        ArgumentNullException.ThrowIfNull(options);
        Picture picture = Renderer.Render(mesh, camera, options with { Opacity = options.Opacity * GhostOpacity });
        Picture bones = Renderer.Render(figure, camera, options with { Shading = ShadingMode.Smooth, Backdrop = BackdropKind.Transparent, Ground = GroundKind.None });
        picture.Overlay(bones, 0, 0);
        return picture;
    }

    /// <summary>The head of the creature in rest pose from a named side.</summary>
    public static Picture TakeFace(Creature creature, View view, RenderOptions options)
    {
        ArgumentNullException.ThrowIfNull(creature);
        ArgumentNullException.ThrowIfNull(options);
        BoundingBox head = HeadBounds(creature);
        Camera camera = Camera.CloseUp(view, head.Centre, head.Diagonal * 0.5f * FaceRoom, options.Width / (float)options.Height);
        return Dressed(creature, RenderMesh.From(creature), camera, options);
    }

    private static RenderMesh OnItsWay(Creature creature, View view)
    {
        ArgumentNullException.ThrowIfNull(creature);
        bool alongWings = view is View.Front or View.Back or View.Top;
        return MomentOfMotion.Of(creature, alongWings && creature.Blueprint.Kind == LocomotionKind.Flying ? JointRole.Wing : null);
    }

    // The creature under an atlas about as fine as the picture; faces of one colour need none.
    private static Picture Dressed(Creature creature, RenderMesh mesh, Camera camera, RenderOptions options)
    {
        if (TakesTextures(options))
        {
            mesh = mesh.WithTextures(CreatureTextures.Bake(creature, AtlasFineness.SizeFor(mesh, camera, options.Height)));
        }

        return Renderer.Render(mesh, camera, options);
    }

    private static bool TakesTextures(RenderOptions options) => options.Shading is not (ShadingMode.Flat or ShadingMode.Faceted);

    private static Camera Fit(Creature creature, RenderMesh mesh, View view, RenderOptions options) =>
        Camera.Fit(Views.Angle(view, creature), mesh.Positions, options.Width / (float)options.Height, fieldOfViewDegrees: Views.FieldOfView(view));

    // Around what the head, the jaw and the eyes move most, as far about the eyes as the snout reaches ahead of them: antlers and collars may go beyond the picture. Around everything when there is no head.
    private static BoundingBox HeadBounds(Creature creature)
    {
        Vector3[] positions = creature.Mesh.Positions.ToArray();
        int[] head = Enumerable.Range(0, positions.Length).Where(i => RoleOf(i) is JointRole.Head or JointRole.Jaw or JointRole.Eye or JointRole.Lid).ToArray();
        int[] eyes = Array.FindAll(head, i => RoleOf(i) == JointRole.Eye);
        if (head.Length == 0)
        {
            return BoundingBox.Of(positions);
        }

        if (eyes.Length > 0)
        {
            BoundingBox pair = BoundingBox.Of(Array.ConvertAll(eyes, i => positions[i]));
            float reach = Math.Max(pair.Diagonal, head.Max(i => positions[i].Z) - pair.Centre.Z);
            head = Array.FindAll(head, i => Vector3.Distance(positions[i], pair.Centre) <= AboutTheEyes * reach);
        }

        return BoundingBox.Of(Array.ConvertAll(head, i => positions[i]));

        JointRole RoleOf(int vertex) => creature.Skeleton.Joints[creature.Mesh.Weights[vertex].Joint0].Role;
    }
}
