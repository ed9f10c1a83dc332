using System;
using System.IO;
using System.Linq;
using System.Net;
using System.Net.Http;
using System.Text.Json;
using System.Threading;
using System.Threading.Tasks;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Gltf;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.SampleProjects;

/// <summary>The server of the samples, asked over HTTP.</summary>
public sealed class ServerTests(SampleServer server) : IClassFixture<SampleServer>
{
    private readonly HttpClient client = server.Client;

    private static CancellationToken Stop => TestContext.Current.CancellationToken;

    [Fact]
    public async Task Creatures_come_as_the_library_writes_them()
    {
        CreatureOptions options = CreatureOptions.Default with { Kind = RequestedKind.Swimming };
        var expected = new MemoryStream();
        GlbWriter.Write(CreatureGenerator.Generate(7, options), new GltfOptions { Provenance = OptionsJson.Write(options) }, expected);
        using HttpResponseMessage glb = await client.GetAsync("creature/7.glb?kind=swimming", Stop);
        Assert.Equal(HttpStatusCode.OK, glb.StatusCode);
        Assert.Equal("model/gltf-binary", glb.Content.Headers.ContentType!.MediaType);
        Assert.Equal(expected.ToArray(), await glb.Content.ReadAsByteArrayAsync(Stop));
        Assert.Equal(BlueprintJson.Write(BlueprintSampler.Sample(7, options)), await client.GetStringAsync("creature/7.json?kind=swimming", Stop));
        byte[] png = await client.GetByteArrayAsync("creature/7.png?kind=swimming&size=32&view=side", Stop);
        Assert.Equal([0x89, (byte)'P', (byte)'N', (byte)'G'], png[..4]);
        Assert.Equal([32, 32], [png[19], png[23]]);

        using HttpResponseMessage health = await client.GetAsync("health", Stop);
        using JsonDocument state = JsonDocument.Parse(await health.Content.ReadAsStringAsync(Stop));
        Assert.Equal("healthy", state.RootElement.GetProperty("status").GetString());
        Assert.Equal(CreatureBlueprint.CurrentAlgorithm, state.RootElement.GetProperty("algorithm").GetInt32());
    }

    [Fact]
    public async Task Who_has_a_creature_already_is_told_so()
    {
        using HttpResponseMessage first = await client.GetAsync("creature/7.json", Stop);
        Assert.True(first.Headers.CacheControl!.Public);
        Assert.NotNull(first.Headers.CacheControl.MaxAge);
        using var again = new HttpRequestMessage(HttpMethod.Get, "creature/7.json");
        again.Headers.IfNoneMatch.Add(first.Headers.ETag!);
        using HttpResponseMessage second = await client.SendAsync(again, Stop);
        Assert.Equal(HttpStatusCode.NotModified, second.StatusCode);
        Assert.Empty(await second.Content.ReadAsByteArrayAsync(Stop));
        foreach (string other in new[] { "creature/8.json", "creature/7.json?kind=flying", "creature/7.json?individual=1", "creature/7.png?size=16" })
        {
            using HttpResponseMessage answer = await client.GetAsync(other, Stop);
            Assert.NotEqual(first.Headers.ETag, answer.Headers.ETag);
        }
    }

    [Theory]
    [InlineData("creature/x.glb", "'x.glb'; expected a seed")]
    [InlineData("creature/7.obj", "'7.obj'; expected a seed")]
    [InlineData("creature/18446744073709551616.glb", "expected a seed")]
    [InlineData("creature/7.png?size=4000", "size = '4000'; expected a whole number 16..1024")]
    [InlineData("creature/7.glb?kind=crawling", "kind = 'crawling'; expected one of any, walking, flying, swimming")]
    [InlineData("creature/7.glb?textures=4096", "textures = '4096'; expected one of none")]
    [InlineData("creature/7.glb?colour=red", "'colour'; expected one of kind")]
    public async Task Bad_requests_are_told_what_was_expected(string path, string message)
    {
        using HttpResponseMessage answer = await client.GetAsync(path, Stop);
        Assert.Equal(HttpStatusCode.BadRequest, answer.StatusCode);
        using JsonDocument problem = JsonDocument.Parse(await answer.Content.ReadAsStringAsync(Stop));
        Assert.Contains(message, problem.RootElement.GetProperty("detail").GetString(), StringComparison.Ordinal);
    }

    [Fact(Explicit = true)]
    public async Task Too_many_at_once_are_sent_away_and_those_that_leave_make_room()
    {
        using var leave = new CancellationTokenSource();
        Task<HttpResponseMessage>[] many = Enumerable.Range(0, 12).Select(i => client.GetAsync($"creature/{i}.glb?textures=1024&clips=all", leave.Token)).ToArray();
        Task<HttpResponseMessage> rejected = await Task.WhenAny(many);
        Assert.Equal(HttpStatusCode.ServiceUnavailable, (await rejected).StatusCode);
        Assert.NotNull((await rejected).Headers.RetryAfter);
        await leave.CancelAsync();
        await Task.WhenAll(many.Select(task => task.ContinueWith(_ => { }, CancellationToken.None, TaskContinuationOptions.None, TaskScheduler.Default)));

        // Nobody waits for those any more; the next one is served.
        for (int i = 0; i < 600; i++)
        {
            using HttpResponseMessage next = await client.GetAsync("creature/7.json", Stop);
            if (next.StatusCode == HttpStatusCode.OK)
            {
                return;
            }

            await Task.Delay(50, Stop);
        }

        Assert.Fail("the server never had room again");
    }
}
