using System;
using System.IO;
using System.Text.Json;
using System.Threading.Tasks;
using Xunit;

namespace CreatureGen.Tests.Gltf;

public sealed class KhronosValidatorTests(CreatureFolder folder)
{
    [Fact]
    public async Task The_validator_of_the_standard_finds_nothing_to_object_to()
    {
        (int exitCode, string output, string errors) = await GltfTools.RunAsync("validate.mjs", folder.Path, TestContext.Current.CancellationToken);
        Assert.True(output.Length > 0, errors);
        JsonElement totals = JsonDocument.Parse(output).RootElement;
        Assert.Equal(2 * ((3 * CreatureFiles.OfEachKind) + 2), folder.Files.Count);
        Assert.Equal(folder.Files.Count, totals.GetProperty("files").GetInt32());
        Assert.True(exitCode == 0, output);
        Assert.Equal(0, totals.GetProperty("errors").GetInt32());
        Assert.Equal(0, totals.GetProperty("warnings").GetInt32());
        Assert.Equal(0, totals.GetProperty("hints").GetInt32());

        // Texture coordinates are there for those who bring a texture; the validator mentions that the file itself has none.
        JsonElement only = Assert.Single(totals.GetProperty("issues").EnumerateArray());
        Assert.Equal("UNUSED_OBJECT", only.GetProperty("code").GetString());
        Assert.EndsWith("/attributes/TEXCOORD_0", only.GetProperty("pointer").GetString(), StringComparison.Ordinal);
    }

    [Fact(Explicit = true)]
    public async Task The_validator_does_find_what_is_wrong()
    {
        string broken = Directory.CreateTempSubdirectory("creaturegen-").FullName;
        try
        {
            GlbFile file = GlbFile.Of(folder.Files[0].Creature);
            int offset = file.BinaryStart + file.View(file.Attribute("WEIGHTS_0")).GetProperty("byteOffset").GetInt32();
            file.Bytes[offset + 3] ^= 0x40;
            File.WriteAllBytes(Path.Combine(broken, "broken.glb"), file.Bytes);
            (int exitCode, string output, _) = await GltfTools.RunAsync("validate.mjs", broken, TestContext.Current.CancellationToken);
            Assert.Equal(1, exitCode);
            Assert.Contains("ACCESSOR_WEIGHTS_NON_NORMALIZED", output, StringComparison.Ordinal);
        }
        finally
        {
            Directory.Delete(broken, recursive: true);
        }
    }

    [Fact]
    public async Task A_folder_without_files_is_not_a_pass()
    {
        string empty = Directory.CreateTempSubdirectory("creaturegen-").FullName;
        try
        {
            foreach (string script in new[] { "validate.mjs", "read.mjs" })
            {
                (int exitCode, _, string errors) = await GltfTools.RunAsync(script, empty, TestContext.Current.CancellationToken);
                Assert.Equal(2, exitCode);
                Assert.StartsWith("no .glb file in ", errors, StringComparison.Ordinal);
            }
        }
        finally
        {
            Directory.Delete(empty);
        }
    }
}
