using System;
using System.IO;
using System.Linq;
using System.Numerics;
using System.Text.Json;
using System.Threading.Tasks;
using CreatureGen.Anatomy;
using CreatureGen.Creatures;
using CreatureGen.Gltf;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Gltf;

public sealed class GlbTextureTests
{
    private const int Size = 256;

    private static readonly Creature Subject = CreatureGenerator.Build(BlueprintSampler.Sample(22, LocomotionKind.Walking));

    [Fact]
    public void A_file_with_an_atlas_holds_three_pictures_of_the_size_asked_for()
    {
        GlbFile file = GlbFile.Of(Subject, new GltfOptions { TextureSize = Size });
        JsonElement images = file.Json.GetProperty("images");
        Assert.Equal(["BaseColour", "Normal", "Roughness"], images.EnumerateArray().Select(image => image.GetProperty("name").GetString()));
        foreach (JsonElement image in images.EnumerateArray())
        {
            Assert.Equal("image/png", image.GetProperty("mimeType").GetString());
            JsonElement view = file.Json.GetProperty("bufferViews")[image.GetProperty("bufferView").GetInt32()];
            Assert.False(view.TryGetProperty("target", out _));
            ReadOnlySpan<byte> png = file.Bytes.AsSpan(file.BinaryStart + view.GetProperty("byteOffset").GetInt32(), view.GetProperty("byteLength").GetInt32());
            Assert.True(png.StartsWith((ReadOnlySpan<byte>)[0x89, (byte)'P', (byte)'N', (byte)'G']));
            Assert.Equal(Size, (png[16] << 24) | (png[17] << 16) | (png[18] << 8) | png[19]);
            Assert.Equal(Size, (png[20] << 24) | (png[21] << 16) | (png[22] << 8) | png[23]);
        }
    }

    [Fact]
    public void Skin_is_white_under_its_atlas_and_pieces_keep_their_colours()
    {
        GlbFile file = GlbFile.Of(Subject, new GltfOptions { TextureSize = Size });
        double[] texcoords = file.Numbers(file.Attribute("TEXCOORD_0"));
        double[] colours = file.Numbers(file.Attribute("COLOR_0"));
        int coloured = 0;
        for (int v = 0; v < texcoords.Length / 2; v++)
        {
            bool white = colours[4 * v] == 65535 && colours[(4 * v) + 1] == 65535 && colours[(4 * v) + 2] == 65535;
            bool piece = CreatureTextures.KeepsItsColour(new Vector2((float)texcoords[2 * v], (float)texcoords[(2 * v) + 1]));
            Assert.True(white || piece);
            coloured += white ? 0 : 1;
        }

        Assert.True(coloured > 100);
    }

    [Fact]
    public void All_materials_take_occlusion_from_the_picture_of_the_roughness()
    {
        GlbFile file = GlbFile.Of(Subject, new GltfOptions { TextureSize = Size });
        foreach (JsonElement material in file.Json.GetProperty("materials").EnumerateArray())
        {
            int roughness = material.GetProperty("pbrMetallicRoughness").GetProperty("metallicRoughnessTexture").GetProperty("index").GetInt32();
            Assert.Equal(roughness, material.GetProperty("occlusionTexture").GetProperty("index").GetInt32());
        }

        JsonElement plain = GlbFile.Of(Subject, GltfOptions.Default).Json.GetProperty("materials")[0];
        Assert.False(plain.TryGetProperty("occlusionTexture", out _));
    }

    [Fact]
    public void Tangents_lie_in_the_skin_and_follow_u()
    {
        GlbFile file = GlbFile.Of(Subject, new GltfOptions { TextureSize = Size });
        double[] tangents = file.Numbers(file.Attribute("TANGENT"));
        double[] normals = file.Numbers(file.Attribute("NORMAL"));
        double[] positions = file.Numbers(file.Attribute("POSITION"));
        double[] texcoords = file.Numbers(file.Attribute("TEXCOORD_0"));
        double[] corners = file.Numbers(file.Primitive.GetProperty("indices").GetInt32());
        for (int v = 0; v < tangents.Length / 4; v++)
        {
            double along = (tangents[4 * v] * normals[3 * v]) + (tangents[(4 * v) + 1] * normals[(3 * v) + 1]) + (tangents[(4 * v) + 2] * normals[(3 * v) + 2]);
            Assert.InRange(along, -1e-4, 1e-4);
            Assert.Equal(1, Math.Abs(tangents[(4 * v) + 3]));
        }

        // Over each triangle of the skin all three corners agree about the side of the third axis, and it is the one that the texture has there.
        int checkedTriangles = 0;
        for (int t = 0; t < corners.Length; t += 3)
        {
            int a = (int)corners[t], b = (int)corners[t + 1], c = (int)corners[t + 2];
            double area = ((texcoords[2 * b] - texcoords[2 * a]) * (texcoords[(2 * c) + 1] - texcoords[(2 * a) + 1])) - ((texcoords[(2 * b) + 1] - texcoords[(2 * a) + 1]) * (texcoords[2 * c] - texcoords[2 * a]));
            if (Math.Abs(area) < 1e-9)
            {
                continue;
            }

            foreach (int v in new[] { a, b, c })
            {
                Assert.Equal(area < 0 ? 1 : -1, tangents[(4 * v) + 3]);
            }

            checkedTriangles++;
        }

        Assert.True(checkedTriangles > 2000);
        Assert.Equal(positions.Length / 3, tangents.Length / 4);
    }

    [Theory]
    [InlineData(100)]
    [InlineData(-1)]
    [InlineData(8192)]
    public void A_size_out_of_range_is_refused_and_nothing_is_written(int size)
    {
        using var stream = new MemoryStream();
        Assert.Throws<ArgumentOutOfRangeException>(() => GlbWriter.Write(Subject, new GltfOptions { TextureSize = size }, stream));
        Assert.Equal(0, stream.Length);
    }

    [Fact(Explicit = true)]
    public async Task The_validator_of_the_standard_finds_nothing_in_files_with_atlases()
    {
        string folder = Directory.CreateTempSubdirectory("creaturegen-").FullName;
        try
        {
            int count = 0;
            foreach (LocomotionKind kind in Enum.GetValues<LocomotionKind>())
            {
                foreach (LodChoice levels in new[] { LodChoice.Finest, LodChoice.Tenth, LodChoice.All })
                {
                    foreach (Shading shading in Enum.GetValues<Shading>())
                    {
                        Creature creature = CreatureGenerator.Build(BlueprintSampler.Sample((ulong)(Thoroughness.IsExhaustive ? count : 0), kind));
                        await File.WriteAllBytesAsync(Path.Combine(folder, $"{count++:000}.glb"), GlbFile.Write(creature, new GltfOptions { TextureSize = Size, Lods = levels, Shading = shading }), TestContext.Current.CancellationToken);
                    }
                }
            }

            (int exitCode, string output, string errors) = await GltfTools.RunAsync("validate.mjs", folder, TestContext.Current.CancellationToken);
            Assert.True(exitCode == 0, output + errors);
            JsonElement totals = JsonDocument.Parse(output).RootElement;
            Assert.Equal(count, totals.GetProperty("files").GetInt32());
            Assert.Equal(0, totals.GetProperty("warnings").GetInt32());
        }
        finally
        {
            Directory.Delete(folder, recursive: true);
        }
    }
}
