// Squares pulled from a buffer, and a pass over the whole target: what the package's own shaders do.
Shader "Tests/Quads"
{
    Properties
    {
        _Tint ("Tint", Color) = (1, 1, 1, 1)
        [Enum(UnityEngine.Rendering.CompareFunction)] _ZTest ("Depth test", Float) = 4
        _Cull ("Cull", Range(0, 2)) = 0
        _MainTex ("Source", 2D) = "white" {}
    }
    HLSLINCLUDE
    struct Square
    {
        float4 CentreAndSize;
        float4 Color;
    };

    StructuredBuffer<Square> _Squares;
    float4 _Tint;
    ENDHLSL

    SubShader
    {
        Tags { "RenderType" = "Opaque" "Queue" = "Geometry" }
        ZTest [_ZTest]

        Pass
        {
            Name "Squares"
            Tags { "LightMode" = "Always" }
            ZWrite On
            Cull [_Cull]

            HLSLPROGRAM
            #pragma target 4.5
            #pragma vertex Vertex
            #pragma fragment Fragment
            #pragma multi_compile _ NEGATIVE
            #pragma multi_compile_local PLAIN GREY

            float4x4 unity_MatrixVP;
            float4x4 unity_ObjectToWorld;

            struct Varyings
            {
                float4 Position : SV_Position;
                float4 Color : COLOR0;
            };

            Varyings Vertex(uint vertex : SV_VertexID, uint instance : SV_InstanceID)
            {
                // Two triangles, clockwise as they are seen.
                float2 corner = float2(vertex == 2 || vertex == 4 || vertex == 5,
                    vertex == 1 || vertex == 2 || vertex == 4) * 2 - 1;
                Square square = _Squares[instance];
                float4 position = float4(square.CentreAndSize.xyz, 1);
                position.xy += corner * square.CentreAndSize.w;
                Varyings result;
                result.Position = mul(unity_MatrixVP, mul(unity_ObjectToWorld, position));
                result.Color = square.Color;
                return result;
            }

            float4 Fragment(Varyings varyings) : SV_Target
            {
                float4 color = varyings.Color * _Tint;
            #if defined(NEGATIVE)
                color.rgb = 1 - color.rgb;
            #endif
            #if defined(GREY)
                color.rgb = color.g;
            #endif
                return color;
            }
            ENDHLSL
        }

        Pass
        {
            Name "Blended"
            ZWrite Off
            ZTest Always
            Cull Off
            Blend SrcAlpha OneMinusSrcAlpha, One Zero

            HLSLPROGRAM
            #pragma vertex Vertex
            #pragma fragment Fragment

            Texture2D<float4> _MainTex;
            SamplerState sampler_MainTex;

            float4 Vertex(uint vertex : SV_VertexID, out float2 uv : TEXCOORD0) : SV_Position
            {
                uv = float2(vertex == 1 ? 2 : 0, vertex == 2 ? 2 : 0);
                return float4(uv * 2 - 1, 0, 1);
            }

            float4 Fragment(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target
            {
                return _MainTex.Sample(sampler_MainTex, uv) * _Tint;
            }
            ENDHLSL
        }

        Pass
        {
            Name "Eyes"
            Cull Off

            HLSLPROGRAM
            #pragma vertex Vertex
            #pragma fragment Fragment

            struct Varyings
            {
                float4 Position : SV_Position;
                float4 Color : COLOR0;
                uint Eye : SV_RenderTargetArrayIndex;
            };

            Varyings Vertex(uint vertex : SV_VertexID, uint instance : SV_InstanceID)
            {
                float2 uv = float2(vertex == 1 ? 2 : 0, vertex == 2 ? 2 : 0);
                Varyings result;
                result.Position = float4(uv * 2 - 1, 0.5, 1);
                result.Color = _Squares[instance].Color;
                result.Eye = instance & 1u;
                return result;
            }

            float4 Fragment(Varyings varyings) : SV_Target
            {
                return varyings.Color;
            }
            ENDHLSL
        }

        Pass
        {
            Name "Points"

            HLSLPROGRAM
            #pragma vertex Vertex
            #pragma fragment Fragment

            struct Varyings
            {
                float4 Position : SV_Position;
                float Size : PSIZE;
                float4 Color : COLOR0;
            };

            Varyings Vertex(uint instance : SV_InstanceID)
            {
                Varyings result;
                result.Position = float4(_Squares[instance].CentreAndSize.xyz, 1);
                result.Size = _Squares[instance].CentreAndSize.w;
                result.Color = _Squares[instance].Color;
                return result;
            }

            float4 Fragment(Varyings varyings) : SV_Target
            {
                // The same buffer as in the vertex shader, and constants of its own.
                return varyings.Color * _Squares[0].Color * _Tint;
            }
            ENDHLSL
        }
    }
    Fallback Off
}
