// Points that fly away: a triangle around the disc of each.
Shader "FastPoints/Samples/Dissolve"
{
    HLSLINCLUDE
    #pragma target 4.5
    #pragma vertex DissolveVertex
    #pragma fragment DissolveFragment
    #include "Packages/com.fastpoints.dots/Shaders/PointCloudBuffers.hlsl"

    // x: share of the time that has passed; y: how far points fly; z: radius of a disc, in world units.
    float4 _Dissolve;

    // x: the lowest point's height; y: one over the height of all.
    float4 _DissolveHeight;

    struct DissolveVaryings
    {
        float4 PositionClip : SV_POSITION;
        float3 Color : TEXCOORD0;
        float2 Corner : TEXCOORD1;
    };

    // Three numbers from 0 to 1 (Jarzynski and Olano, "Hash Functions for GPU Rendering", 2020: pcg3d).
    float3 RandomOf(uint number)
    {
        uint3 v = uint3(number, number >> 8, number >> 16) * 1664525u + 1013904223u;
        v.x += v.y * v.z;
        v.y += v.z * v.x;
        v.z += v.x * v.y;
        v ^= v >> 16;
        v.x += v.y * v.z;
        v.y += v.z * v.x;
        v.z += v.x * v.y;
        return float3(v >> 8) / 16777216.0;
    }

    // A corner of the triangle, but for its place on the screen; right and up are the camera's.
    DissolveVaryings Dissolve(uint vertex, float3 right, float3 up, out float3 position)
    {
        uint number = vertex / 3u, of = vertex % 3u;
        float4 color;
        FastPoints_Load(number, position, color);
        float3 random = RandomOf(number);
        // From the top down, a little earlier here than there.
        float height = saturate((position.y - _DissolveHeight.x) * _DissolveHeight.y);
        float begin = 0.5 * (1.0 - height) + 0.2 * random.x;
        float age = saturate((_Dissolve.x - begin) / 0.3);
        float turn = 6.2831853 * (random.y + age * 0.5);
        float3 drift = float3(1.0 + 0.4 * cos(turn), 0.6 + 0.8 * random.z, 0.4 * sin(turn));
        position += drift * (age * age * _Dissolve.y);
        DissolveVaryings varyings;
        varyings.Corner = of == 0u ? float2(0.0, 2.0) : float2(of == 1u ? -1.7320508 : 1.7320508, -1.0);
        // Clipped and hidden points have no alpha, and no size then.
        float2 corner = varyings.Corner * (_Dissolve.z * (1.0 - age) * (color.a > 0.0 ? 1.0 : 0.0));
        position += right * corner.x + up * corner.y;
        varyings.PositionClip = 0.0;
        varyings.Color = color.rgb;
        return varyings;
    }

    float4 DissolveFragment(DissolveVaryings varyings) : SV_Target
    {
        if (dot(varyings.Corner, varyings.Corner) > 1.0)
            discard;
        return float4(varyings.Color, 1.0);
    }
    ENDHLSL

    // HDRP's matrices count places from the camera.
    SubShader
    {
        PackageRequirements { "com.unity.render-pipelines.high-definition" }
        Tags { "RenderPipeline" = "HDRenderPipeline" }

        Pass
        {
            Name "Dissolve"
            Tags { "LightMode" = "ForwardOnly" }
            Cull Off

            HLSLPROGRAM
            #include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Common.hlsl"
            #include "Packages/com.unity.render-pipelines.high-definition/Runtime/ShaderLibrary/ShaderVariables.hlsl"

            DissolveVaryings DissolveVertex(uint vertex : SV_VertexID)
            {
                float3 position;
                DissolveVaryings varyings = Dissolve(vertex, UNITY_MATRIX_V[0].xyz, UNITY_MATRIX_V[1].xyz, position);
                varyings.PositionClip = mul(UNITY_MATRIX_VP, float4(GetCameraRelativePositionWS(position), 1.0));
                return varyings;
            }
            ENDHLSL
        }
    }

    // The Built-in pipeline and URP.
    SubShader
    {
        Pass
        {
            Name "Dissolve"
            Cull Off

            HLSLPROGRAM
            // Unity's, of the camera.
            float4x4 unity_MatrixV;
            float4x4 unity_MatrixVP;

            DissolveVaryings DissolveVertex(uint vertex : SV_VertexID)
            {
                float3 position;
                DissolveVaryings varyings = Dissolve(vertex, unity_MatrixV[0].xyz, unity_MatrixV[1].xyz, position);
                varyings.PositionClip = mul(unity_MatrixVP, float4(position, 1.0));
                return varyings;
            }
            ENDHLSL
        }
    }
}
